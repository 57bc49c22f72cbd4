/** Which block fits into which. */

import * as Blockly from "blockly/core";

/** While the server's program is shown every connection is right, whatever types Blockly would ask for. */
export class Checker extends Blockly.ConnectionChecker {
  lenient = false;

  override doTypeChecks(one: Blockly.Connection, other: Blockly.Connection): boolean {
    return this.lenient || super.doTypeChecks(one, other);
  }
}
