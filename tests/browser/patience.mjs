// How long a browser is waited for: it was seen to wait for ever for a key that was pressed while a page was being left, and to never end when asked to.

/** After so many seconds the end of a page or of a browser is not waited for any longer. */
const PARTING = 10;

/** What `work` gives, or an error if it takes longer. */
export function within(seconds, work) {
  let timer = 0;
  const late = new Promise((_, fail) => { timer = setTimeout(() => fail(new Error(`no answer for ${seconds} s`)), 1000 * seconds); });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}

/** Closes a page, a context or a browser; one that does not end is left behind, and ends with the program. */
export const ended = (thing) => within(PARTING, thing.close()).catch(() => {});
