/** The server's pictures: tags, faces, floors. */

import { type Material, SRGBColorSpace, type Texture, TextureLoader } from "three";

type Pictured = Material & { map: Texture | null; color: { set(colour: string): unknown } };

/** Loads pictures into materials and redraws the world when one has loaded. */
export class Pictures {
  private readonly loader = new TextureLoader();
  private readonly textures = new Set<Texture>();

  constructor(private readonly changed: () => void) {}

  /** Show the picture at an address relative to the page; until it has loaded, the plain colour. */
  on(material: Pictured, address: string): void {
    this.loader.load(address, (texture) => {
      texture.colorSpace = SRGBColorSpace;
      texture.anisotropy = 4;
      this.textures.add(texture);
      material.map = texture;
      material.color.set("#ffffff");
      material.needsUpdate = true;
      this.changed();
    });
  }

  dispose(): void {
    for (const texture of this.textures) texture.dispose();
    this.textures.clear();
  }
}
