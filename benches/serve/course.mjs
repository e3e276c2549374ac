// A made course of many chapters, as large as a preview has to bear: formulas, references, citations, values, claims, ten exhibits a chapter.
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const EXHIBITS = 10;
const SAMPLERS = ["independent", "latin-hypercube", "halton", "sobol", "sobol+owen"];

function exhibit(chapter, at) {
  const id = `fig-${chapter}-${at}`, seed = 1000 * chapter + at, sampler = SAMPLERS[at % SAMPLERS.length];
  if (at % 3 === 0) {
    return `\`\`\`experiment
id = "${id}"
kind = "points"
sampler = "${sampler}"
n = 64
seed = ${seed}
caption = "Points of experiment ${at} in $[0,1)^2$."
\`\`\``;
  }
  return `\`\`\`experiment
id = "${id}"
kind = "convergence"
integrand = "exp(-x^2-y^2)"
samplers = ["independent", "${sampler === "independent" ? "halton" : sampler}"]
n = "2^2..2^7"
replicates = 16
seed = ${seed}
caption = "The error over $N$ in experiment ${at}, chapter ${chapter}."
claims."slope.independent" = { near = -0.5, within = 0.5 }
\`\`\``;
}

function section(chapter, at, chapters) {
  const id = `fig-${chapter}-${at}`, other = `fig-${(chapter % chapters) + 1}-${(at + 1) % EXHIBITS}`;
  const value = at % 3 === 0 ? "" : ` The slope is \`=${id}.slope.independent:.2\`.`;
  const words = Array.from({ length: 3 }, (_, paragraph) => `Paragraph ${paragraph} of section ${at}: the estimate $\\hat F_N = \\frac{1}{N}\\sum_{i=1}^{N} f(X_i)$ of $\\int_{[0,1]^2} f$
has the variance $\\sigma^2/N$ if the points are *independent*, as @${id} shows and @${other} confirms, and as @eq-${chapter}-${at} states.${value}
What follows is text of the usual length, so that the page is as long as pages are, with a \`piece of code\`, a [link](#fig-${chapter}-0) and
some more words behind it, until the line and the paragraph are full.`).join("\n\n");
  return `## Section ${at}

${words}

$$ \\operatorname{Var}\\hat F_N = \\frac{1}{N^2}\\sum_{i,j} \\operatorname{Cov}\\bigl(f(X_i), f(X_j)\\bigr) $$ {#eq-${chapter}-${at}}

${exhibit(chapter, at)}

- one, with $a_{${at}}$
- another, with $b_{${at}}$
`;
}

/** Writes the course into `folder`. */
export function make(folder, chapters) {
  mkdirSync(join(folder, "chapters"), { recursive: true });
  writeFileSync(join(folder, "chapters/workbook.toml"), `title = "A made course"\nauthors = ["A script"]\ntyped_numbers = "allowed"\n[budgets]\npage = 4000\nsite = 400_000\n`);
  for (let chapter = 1; chapter <= chapters; chapter += 1) {
    const parts = Array.from({ length: EXHIBITS }, (_, at) => section(chapter, at, chapters));
    const name = `${String(chapter).padStart(3, "0")}-chapter-${chapter}.md`;
    writeFileSync(join(folder, "chapters", name), `+++\ntitle = "Chapter ${chapter}"\nsummary = "What chapter ${chapter} is about."\n+++\n\nThe opening of the chapter.\n\n${parts.join("\n")}`);
  }
}
