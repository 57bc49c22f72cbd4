/** Decides which connections are allowed. */

import * as Blockly from "blockly/core";

/** While the server's program is shown, every connection is allowed, whatever Blockly's types say. */
export class Checker extends Blockly.ConnectionChecker {
  lenient = false;

  override doTypeChecks(one: Blockly.Connection, other: Blockly.Connection): boolean {
    return this.lenient || super.doTypeChecks(one, other);
  }
}
