/** The page's letters, before it is shown: words that change their letters change their size, too. */

import "./fonts.css";

/** ms; after that the page is shown with letters of the computer. */
const PATIENCE = 3000;

/** Return once the letters of the page's words are there, or after a while. */
export async function startFonts(fonts: FontFaceSet | undefined = document.fonts): Promise<void> {
  const late = new Promise((resolve) => setTimeout(resolve, PATIENCE));
  const loaded = fonts?.load('1em "Nunito Variable"').catch(() => []);
  await Promise.race([loaded, late]);
}
