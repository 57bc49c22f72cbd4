import { usePage } from "../../model/page";
import { comparison } from "./links";

/** Of a project from a link, whether the last run was the one that was shared. */
export function Compared() {
  const compared = usePage().links.compared.value;
  if (!compared) return null;
  return <p>{comparison(compared)}</p>;
}
