/** The examples' words in the page's language. */

import { t, translated } from "../../i18n";
import type { ExampleChoice } from "../../protocol/messages";

/** The title of an example, which says how many robots it has if there are several. */
export function exampleTitle(example: ExampleChoice): string {
  const { robots = 1 } = example;
  const title = plainTitle(example);
  return robots > 1 ? `${title} ${t("page-project-example-robots", { count: robots })}` : title;
}

/** The title alone, as a name for a project. */
export function plainTitle({ name, title }: ExampleChoice): string {
  return translated(`page-catalog-example-${name}`, title);
}

export function exampleText({ name, description }: ExampleChoice): string {
  return translated(`page-catalog-example-text-${name}`, description);
}
