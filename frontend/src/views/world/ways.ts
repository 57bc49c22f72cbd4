/** The ways of two compared runs, one over the other, and where they parted. */

import { Group, Mesh, MeshBasicMaterial, RingGeometry } from "three";

import type { Way } from "../../model/kept-runs";
import { Trail } from "./trail";

/** While the runs did the same, the second way lies on the first one, which is wider. */
const HALF_WIDTHS = [9, 4];
const HEIGHTS = [1.7, 1.9];
/** The inner radius of the rings where they parted, and their width, mm. */
const RADII = [44, 34];
const RING = 7;
const RING_HEIGHT = 2;
const CORNERS = 40;

export class Ways {
  readonly object = new Group();
  private trails: Trail[] = [];
  private rings: Mesh<RingGeometry, MeshBasicMaterial>[] = [];

  /** Whether nothing is shown. */
  get empty(): boolean {
    return this.trails.length === 0;
  }

  show(ways: readonly Way[]): void {
    this.clear();
    ways.forEach((way, index) => this.add(way, index));
    const meshes = [...this.trails.map(({ mesh }) => mesh), ...this.rings];
    if (meshes.length) this.object.add(...meshes);
  }

  clear(): void {
    this.object.clear();
    for (const trail of this.trails) trail.dispose();
    for (const { geometry, material } of this.rings) {
      geometry.dispose();
      material.dispose();
    }
    this.trails = [];
    this.rings = [];
  }

  private add({ points, colour, parted }: Way, index: number): void {
    const trail = new Trail({ colour, halfWidth: HALF_WIDTHS[index] ?? 0, height: HEIGHTS[index] ?? 0 });
    for (const [, x, y] of points) trail.extend(x, y);
    this.trails.push(trail);
    if (!parted) return;
    const radius = RADII[index] ?? 0;
    const ring = new Mesh(
      new RingGeometry(radius, radius + RING, CORNERS),
      new MeshBasicMaterial({ color: colour, toneMapped: false }),
    );
    ring.position.set(...parted, RING_HEIGHT);
    ring.renderOrder = trail.mesh.renderOrder + 1;
    this.rings.push(ring);
  }
}
