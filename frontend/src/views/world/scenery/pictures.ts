/** The server's pictures: tags, faces, floors. */

import { type ColorSpace, type Material, SRGBColorSpace, type Texture, TextureLoader } from "three";

type Pictured = Material & { map: Texture | null; color: { set(colour: string): unknown } };

/** Counts what is being loaded. */
export interface Loading {
  begin(): void;
  end(): void;
}

/** Loads pictures into materials and redraws the world when one has loaded. */
export class Pictures {
  private readonly loader = new TextureLoader();
  private readonly textures = new Set<Texture>();
  private readonly loaded = new Map<string, Texture>();

  /**
   * @param changed is called when one has loaded.
   * @param base the address that pictures are relative to: that of the page, or of a page in a folder of it.
   * @param loading counts the pictures that are being loaded.
   */
  constructor(
    private readonly changed: () => void,
    base = "",
    private readonly loading: Loading | null = null,
  ) {
    this.loader.setPath(base);
  }

  /** Show the picture at an address relative to the page; until it has loaded, the plain colour. */
  on(material: Pictured, address: string): void {
    this.load(address, SRGBColorSpace, (texture) => {
      material.map = texture;
      material.color.set("#ffffff");
      material.needsUpdate = true;
    });
  }

  /** Load the picture at an address relative to the page. */
  load(address: string, space: ColorSpace, use: (texture: Texture) => void): void {
    const before = this.loaded.get(address);
    if (before) return use(before);
    this.loading?.begin();
    const missing = () => this.loading?.end();
    const shown = (texture: Texture) => {
      texture.colorSpace = space;
      texture.anisotropy = 4;
      this.loaded.set(address, texture);
      use(this.keep(texture));
      this.changed();
      this.loading?.end();
    };
    this.loader.load(address, shown, undefined, missing);
  }

  /** Keep a texture until these pictures are disposed of. */
  keep<T extends Texture>(texture: T): T {
    this.textures.add(texture);
    return texture;
  }

  dispose(): void {
    for (const texture of this.textures) texture.dispose();
    this.textures.clear();
    this.loaded.clear();
  }
}
