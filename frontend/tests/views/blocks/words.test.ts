/** Every text of Blockly that the page shows is in the page's language. */

import * as english from "blockly/msg/en";
import * as spanish from "blockly/msg/es";
import { describe, expect, it } from "vitest";

import ours from "../../../src/views/blocks/words/en.json";
import nuestras from "../../../src/views/blocks/words/es.json";

type Messages = Readonly<Record<string, string>>;

/** Parts of Blockly that the page doesn't have, addresses, and colours. */
const UNUSED = /BACKPACK|MINIMAP|BITMAP|HELPURL|HUE$/;
/** The same word in both languages, beside names of keys and of systems, and signs. */
const SHARED = new Set([
  ...["ARIA_TYPE_FIELD_COLOUR", "INPUT_LABEL_MATH_DIVISOR", "SHORTCUTS_GENERAL"],
  ...["ALT_KEY", "CHROME_OS", "ESCAPE", "LINUX", "MAC_OS", "WINDOWS"],
  ...["MATH_TRIG_ACOS", "MATH_TRIG_ASIN", "MATH_TRIG_ATAN", "MATH_TRIG_COS", "MATH_TRIG_TAN"],
]);
const EN: Messages = { ...(english as object), ...ours };
const ES: Messages = { ...(spanish as object), ...nuestras };
const SHOWN = Object.keys(EN).filter((code) => !UNUSED.test(code));

describe("Blockly's texts in Spanish", () => {
  it("are all there", () => {
    const isLeft = (code: string) => EN[code] === ES[code] && /[a-z]{3}/i.test(EN[code] ?? "");
    expect(SHOWN.filter((code) => !(code in ES) || (isLeft(code) && !SHARED.has(code)))).toEqual([]);
  });

  it("are ours wherever those in English are", () => {
    expect(Object.keys(ours).filter((code) => !(code in nuestras))).toEqual([]);
  });

  it("say tú", () => {
    expect(
      SHOWN.filter((code) => /\b(Presione|Use|Mantenga|Seleccione|Introduzca|Haga|Elija)\b/.test(ES[code] ?? "")),
    ).toEqual([]);
  });

  it("have the same values as in English", () => {
    const valuesOf = (text = "") => (text.match(/%\d/g) ?? []).sort().join();
    expect(Object.keys(nuestras).filter((code) => valuesOf(EN[code]) !== valuesOf(ES[code]))).toEqual([]);
  });
});
