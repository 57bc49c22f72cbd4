/** Classes for the tokens of both notations; text.css sets their colours. */

import { tagHighlighter, tags } from "@lezer/highlight";

export const highlighter = tagHighlighter([
  { tag: tags.keyword, class: "tok-keyword" },
  { tag: [tags.bool, tags.null, tags.atom], class: "tok-constant" },
  { tag: tags.number, class: "tok-number" },
  { tag: [tags.string, tags.character], class: "tok-string" },
  { tag: [tags.special(tags.string), tags.escape], class: "tok-special" },
  { tag: tags.comment, class: "tok-comment" },
  { tag: [tags.function(tags.propertyName), tags.function(tags.variableName)], class: "tok-call" },
  {
    tag: [
      tags.definition(tags.variableName),
      tags.function(tags.definition(tags.variableName)),
      tags.definition(tags.className),
    ],
    class: "tok-definition",
  },
  { tag: [tags.self, tags.meta], class: "tok-self" },
  { tag: [tags.operator, tags.punctuation], class: "tok-operator" },
  { tag: tags.invalid, class: "tok-invalid" },
]);
