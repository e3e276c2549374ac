// Nothing is asked of another host, every file is found, and the console stays empty.
export const about = "no request to another host, no missing file, no message in the console";
export const views = ["wide", "narrow", "plain"];

export async function look({ seen, report }) {
  for (const url of new Set(seen.requests)) report(`asks another host: ${url}`);
  for (const message of new Set(seen.messages)) report(message);
  return seen.requests.length + seen.messages.length;
}
