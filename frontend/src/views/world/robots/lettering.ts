/** Text on the screens of robots: wrapped, and as large as fits. */

const SMALLEST = 10;
const LINE = 1.2;

/** Lines of a text that are no wider than a width; words that are longer are cut. */
export function wrap(text: string, width: number, measure: (line: string) => number): string[] {
  return text.split("\n").flatMap((paragraph) => wrapParagraph(paragraph, width, measure));
}

function wrapParagraph(paragraph: string, width: number, measure: (line: string) => number): string[] {
  const lines: string[] = [];
  let line = "";
  for (const word of paragraph.split(/\s+/).flatMap((long) => cut(long, width, measure))) {
    const longer = line ? `${line} ${word}` : word;
    if (measure(longer) <= width || !line) line = longer;
    else {
      lines.push(line);
      line = word;
    }
  }
  return [...lines, line];
}

function cut(word: string, width: number, measure: (line: string) => number): string[] {
  const pieces: string[] = [];
  let piece = "";
  for (const letter of word) {
    if (piece && measure(piece + letter) > width) {
      pieces.push(piece);
      piece = "";
    }
    piece += letter;
  }
  return [...pieces, piece];
}

/** Write a text into the middle of a canvas, in the largest size that fits. */
export function letter(pen: CanvasRenderingContext2D, text: string, colour: string, largest: number): void {
  const { width, height } = pen.canvas;
  const [wide, tall] = [width * 0.92, height * 0.92];
  const sized = (size: number): string[] => {
    pen.font = `600 ${size}px sans-serif`;
    return wrap(text, wide, (line) => pen.measureText(line).width);
  };
  let size = largest;
  while (size > SMALLEST && sized(size).length * size * LINE > tall) size -= 2;
  const lines = sized(size);
  pen.fillStyle = colour;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  const top = height / 2 - ((lines.length - 1) * size * LINE) / 2;
  lines.forEach((line, i) => pen.fillText(line, width / 2, top + i * size * LINE));
}
