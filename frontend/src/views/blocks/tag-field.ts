/** A field for a tag. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { actionsOf } from "./actions";
import { defineField } from "./fields";

const TAGS = "lb-tag-names";

/** A tag by number or name, with suggestions of the known names. */
class FieldTag extends Blockly.FieldTextInput {
  protected override widgetCreate_(): HTMLInputElement {
    const input = super.widgetCreate_() as HTMLInputElement;
    const list = document.createElement("datalist");
    list.id = TAGS;
    const names = actionsOf(this.workspace_ ?? undefined)?.tagNames() ?? [];
    list.append(...names.map((name) => new Option(name)));
    input.setAttribute("list", TAGS);
    input.after(list);
    return input;
  }

  override getAriaTypeName(): string {
    return t("page-blocks-tag");
  }
}

export function defineTagField(): void {
  const field = () => new FieldTag();
  defineField("lb_tag", { style: "text_blocks", output: "String", name: "TEXT", field });
}
