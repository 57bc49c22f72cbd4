/** The address of Blockly's pictures and sounds: bundled, never on the internet. */

// The build bundles all these files into one folder (see vite.config.ts).
const files = import.meta.glob<string>("../../../node_modules/blockly/media/*", {
  eager: true,
  query: "?url&no-inline",
  import: "default",
});

const sprites = files["../../../node_modules/blockly/media/sprites.svg"]!;

/** The folder's address, with a slash at the end. */
export const MEDIA = new URL(".", new URL(sprites, document.baseURI)).href;
