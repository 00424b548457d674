// Sets the equations of a site's pages by KaTeX, so that no page needs a script or the network for them.
//   node setEquations.js SITE
// What KaTeX cannot set, and dollars that are left between words, are errors.
"use strict";
const fs = require("fs");
const path = require("path");
const katex = require("katex.js");

const entities = {"&lt;": "<", "&gt;": ">", "&quot;": "\"", "&#39;": "'", "&amp;": "&"};
const asWritten = text => text.replace(/&(?:lt|gt|quot|#39|amp);/g, entity => entities[entity]);
const EQUATION = /<(span|div) class="equation">\\([([])([\s\S]*?)\\[)\]]<\/\1>/g;

function pagesIn(folder) {
  return fs.readdirSync(folder, {withFileTypes: true}).flatMap(entry => {
    const name = path.join(folder, entry.name);
    return entry.isDirectory() ? pagesIn(name) : name.endsWith(".html") ? [name] : [];
  });
}

let errors = 0;
const fail = (page, what) => { console.error(`${page}: ${what}`); ++errors; };

for (const page of pagesIn(process.argv[2])) {
  const html = fs.readFileSync(page, "utf8");
  const set = html.replace(EQUATION, (_, element, bracket, tex) => {
    const displayMode = bracket === "[";
    try {
      const equation = katex.renderToString(asWritten(tex), {displayMode, throwOnError: true, strict: "error"});
      return `<${element} class="equation">${equation}</${element}>`;
    } catch (error) {
      fail(page, error.message);
      return "";
    }
  });
  const text = set.replace(/<(script|style|code|pre|math|annotation)\b[\s\S]*?<\/\1>/g, "").replace(/<[^>]*>/g, "");
  for (const left of text.match(/\$[^$\n]{1,60}\$/g) || []) { fail(page, `no equation: ${left}`); }
  if (set !== html) { fs.writeFileSync(page, set); }
}
process.exit(errors ? 1 : 0);
