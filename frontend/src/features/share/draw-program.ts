/** The drawing of programs, which is loaded when the first one is drawn. */

type DrawProgram = typeof import("../../views/blocks/program-picture").drawProgram;

/** Load what draws a program, and prepare Blockly for it. */
export async function loadDrawing(): Promise<DrawProgram> {
  const [{ drawProgram }, { prepare }] = await Promise.all([
    import("../../views/blocks/program-picture"),
    import("../../views/blocks/prepare"),
  ]);
  prepare();
  return drawProgram;
}
