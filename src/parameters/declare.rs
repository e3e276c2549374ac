//! The declarations: `parameters!` for the parameters of a kind, `choices!` for a parameter that is one of a few words.

/// Declares the parameters of a kind: a struct whose fields are the keys of the fence.
///
/// `name: Type [in limits] [or alias] = default`: limits, another name and a default are optional. The default is a TOML
/// value, read like any that an author writes. `@drawn` before the name marks what only the drawing reads: it is no part of
/// the question, so that changing it draws the result anew and runs nothing.
macro_rules! parameters {
    (
        $(#[doc = $doc:literal])+
        pub struct $struct:ident {
            $(
                $(#[doc = $meaning:literal])+
                $(@$drawn:ident)? $name:ident: $type:ty $([in $limits:expr])? $([or $alias:ident])? $(= $default:expr)?,
            )+
        }
    ) => {
        $(#[doc = $doc])+
        #[derive(Debug, Clone)]
        pub struct $struct {
            $($(#[doc = $meaning])+ pub $name: $type,)+
        }

        impl $struct {
            $(
                fn $name() -> $crate::parameters::Declared<$type> {
                    $crate::parameters::Declared {
                        name: stringify!($name),
                        alias: [$(stringify!($alias),)?].first().copied(),
                        limits: [$($limits,)?].into_iter().next(),
                        default: [$(stringify!($default),)?].first().copied(),
                        meaning: concat!($($meaning),+).trim_ascii(),
                    }
                }
            )+
        }

        impl $crate::parameters::Parameters for $struct {
            fn docs() -> Vec<$crate::parameters::ParameterDoc> {
                vec![$($crate::parameters::document(&Self::$name()),)+]
            }

            fn read(fields: &mut $crate::parameters::Fields<'_>) -> Option<Self> {
                $(let $name = $crate::parameters::read_parameter(fields, &Self::$name());)+
                // A default stands in for what is wrong, so that the rest can be checked all the same.
                Some(Self { $($name: $name.or_else(|| $crate::parameters::fallback(&Self::$name()))?,)+ })
            }

            fn canonical(&self) -> serde_json::Value {
                let mut object = serde_json::Map::new();
                $(
                    let value = $crate::parameters::ParameterType::canonical(&self.$name);
                    object.insert(stringify!($name).to_owned(), value);
                )+
                serde_json::Value::Object(object)
            }

            fn drawn() -> Vec<&'static str> {
                [$($((stringify!($drawn), stringify!($name)),)?)+].into_iter().map(|(_, name): (&str, _)| name).collect()
            }

            fn abouts(&self) -> Vec<&'static $crate::catalogue::About> {
                let mut abouts = Vec::new();
                $(abouts.extend($crate::parameters::ParameterType::abouts(&self.$name));)+
                abouts
            }
        }
    };
}

/// Declares a parameter that is one of a few words.
macro_rules! choices {
    (
        $(#[doc = $doc:literal])+
        pub enum $enum:ident {
            $($(#[doc = $meaning:literal])+ $variant:ident = $word:literal,)+
        }
    ) => {
        $(#[doc = $doc])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $enum { $($(#[doc = $meaning])+ $variant,)+ }

        impl $enum {
            const WORDS: &'static [&'static str] = &[$($word,)+];

            fn word(self) -> &'static str {
                match self { $(Self::$variant => $word,)+ }
            }
        }

        impl $crate::parameters::ParameterType for $enum {
            type Bound = $crate::parameters::Unbounded;

            fn type_name() -> String {
                $crate::parameters::enumerate(Self::WORDS, "or")
            }

            fn schema() -> serde_json::Value {
                serde_json::json!({ "enum": Self::WORDS })
            }

            fn read(
                value: &toml::Spanned<toml::de::DeValue<'_>>,
                _: Option<&std::ops::RangeInclusive<Self::Bound>>,
                complaints: &mut Vec<$crate::parameters::Complaint>,
            ) -> Option<Self> {
                let choice = $crate::parameters::read_word::<Self>(value, Self::WORDS, complaints)?;
                [$(Self::$variant,)+].get(choice).copied()
            }

            fn canonical(&self) -> serde_json::Value {
                self.word().into()
            }
        }
    };
}

pub(crate) use {choices, parameters};
