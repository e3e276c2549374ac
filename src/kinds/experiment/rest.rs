//! Rest: what follows to the end of a result, so that a result that has nothing more is encoded as it always was.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{DeserializeOwned, SeqAccess, Visitor};
use serde::ser::SerializeTuple;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The items at the end of a result, one after the other and without their count: it must be the last field of the data.
///
/// A kind that learns to compute more keeps the bytes of the results that have no more, and with them the reviewed digests.
#[derive(Debug, Clone, PartialEq)]
pub struct Rest<T>(pub Vec<T>);

impl<T: Serialize> Serialize for Rest<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(self.0.len())?;
        self.0.iter().try_for_each(|item| tuple.serialize_element(item))?;
        tuple.end()
    }
}

impl<'de, T: DeserializeOwned> Deserialize<'de> for Rest<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_tuple(usize::MAX, Items(PhantomData))
    }
}

/// Reads items until there is none. What is no item is left, and whoever decodes sees that bytes are left over or differ.
struct Items<T>(PhantomData<T>);

impl<'de, T: DeserializeOwned> Visitor<'de> for Items<T> {
    type Value = Rest<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("items to the end")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Self::Value, A::Error> {
        let mut items = Vec::new();
        while let Ok(Some(item)) = sequence.next_element() {
            items.push(item);
        }
        Ok(Rest(items))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Data {
        first: Vec<u32>,
        more: Rest<(u32, f64)>,
    }

    #[test]
    fn nothing_more_leaves_no_trace() {
        let data = Data { first: vec![1, 300], more: Rest(Vec::new()) };
        let bytes = postcard::to_stdvec(&data).unwrap();
        assert_eq!(bytes, postcard::to_stdvec(&vec![1_u32, 300]).unwrap());
        assert_eq!(postcard::take_from_bytes::<Data>(&bytes).unwrap(), (data, &[][..]));
    }

    #[test]
    fn more_comes_back_whole() {
        let data = Data { first: vec![7], more: Rest(vec![(1, 0.5), (900, -2.0)]) };
        let bytes = postcard::to_stdvec(&data).unwrap();
        assert_eq!(postcard::take_from_bytes::<Data>(&bytes).unwrap(), (data, &[][..]));
    }
}
