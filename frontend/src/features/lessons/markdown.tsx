/** Markdown of a lesson as elements: HTML in it is shown as text, and nothing is fetched from elsewhere. */

import { useSignal } from "@preact/signals";
import { lexer, type Token, type Tokens } from "marked";
import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import type { Workspace } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { DrawnBlocks, DrawnProgram } from "./drawn-blocks";

interface Props {
  readonly text: string;
  /** The name of the lesson, whose pictures may be shown. */
  readonly lesson: string;
  /** The blocks of the code blocks that are drawn, by their text. */
  readonly drawings: Readonly<Record<string, Workspace>>;
  /** Gives the blocks of a Block-Text, which are drawn beside it; null if it has none. */
  readonly blocksOf?: (text: string) => Promise<Workspace | null>;
  /** The addresses of pictures by their names, where there is no server to ask for them. */
  readonly pictures?: Readonly<Record<string, string>>;
  /** Opens the Block-Text of a whole program as a project; nothing without it. */
  readonly open?: (program: string) => void;
}

/** The depth of lists and quotes that is shown. */
const DEEPEST = 12;
/** The first line of what runs, in Block-Text: what has none is only a part of a program. */
const STACK = /^(main|when .*):/m;
const PICTURE = /^(?:\.\/)?(?:pictures\/)?([\w-]{1,60}\.\w{1,8})$/;

export function Markdown(props: Props) {
  return <div class="lesson-text">{shown(lexer(props.text), props, DEEPEST)}</div>;
}

function shown(tokens: readonly Token[], props: Props, depth: number): ComponentChildren {
  if (depth === 0) return null;
  return tokens.map((token, index) => {
    return <Piece key={index} token={token} props={props} depth={depth - 1} />;
  });
}

interface PieceProps {
  readonly token: Token;
  readonly props: Props;
  readonly depth: number;
}

function Piece({ token, props, depth }: PieceProps): ComponentChildren {
  const inside = () => shown(("tokens" in token && token.tokens) || [], props, depth);
  switch (token.type) {
    case "space":
    case "def":
      return null;
    case "heading":
      return <h4>{inside()}</h4>;
    case "paragraph":
      return <p>{inside()}</p>;
    case "blockquote":
      return <blockquote>{inside()}</blockquote>;
    case "strong":
      return <strong>{inside()}</strong>;
    case "em":
      return <em>{inside()}</em>;
    case "del":
      return <del>{inside()}</del>;
    case "codespan":
      return <code>{(token as Tokens.Codespan).text}</code>;
    case "br":
      return <br />;
    case "hr":
      return <hr />;
    case "list":
      return <List list={token as Tokens.List} props={props} depth={depth} />;
    case "code":
      return <Code code={token as Tokens.Code} props={props} />;
    case "table":
      return <Table table={token as Tokens.Table} props={props} depth={depth} />;
    case "image":
      return <Picture image={token as Tokens.Image} props={props} />;
    case "link":
      return <Link link={token as Tokens.Link}>{inside()}</Link>;
    case "text":
      return "tokens" in token && token.tokens ? inside() : (token as Tokens.Text).text;
    case "escape":
      return (token as Tokens.Escape).text;
    default:
      // HTML among them.
      return token.raw;
  }
}

function List({ list, props, depth }: { list: Tokens.List; props: Props; depth: number }) {
  const items = list.items.map((item, index) => <li key={index}>{shown(item.tokens, props, depth)}</li>);
  return list.ordered ? <ol start={Number(list.start) || 1}>{items}</ol> : <ul>{items}</ul>;
}

function Code({ code, props: { drawings, blocksOf, open } }: { code: Tokens.Code; props: Props }) {
  const source = code.text.replace(/^\n+|\n+$/g, "");
  // After the language may be the name of a file.
  const language = code.lang?.trim().split(" ")[0];
  const drawing = language === "blocks" ? drawings[source] : undefined;
  const isProgram = (drawing || language === "blocktext") && STACK.test(source);
  const button = open && isProgram && <OpenButton open={() => open(source)} />;
  if (drawing) {
    return (
      <DrawnProgram key={source} workspace={drawing} text={source}>
        {button}
      </DrawnProgram>
    );
  }
  const text = (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it
    <pre tabIndex={0}>
      <code>{code.text}</code>
    </pre>
  );
  const isDrawn = blocksOf && language === "blocktext";
  return (
    <>
      {isDrawn ? (
        <Example key={source} source={source} blocksOf={blocksOf}>
          {text}
        </Example>
      ) : (
        text
      )}
      {button}
    </>
  );
}

interface ExampleProps {
  readonly source: string;
  readonly blocksOf: (text: string) => Promise<Workspace | null>;
  /** The text. */
  readonly children: ComponentChildren;
}

/** The blocks of an example beside its text, once they are here. */
function Example({ source, blocksOf, children }: ExampleProps) {
  const blocks = useSignal<Workspace | null>(null);
  useEffect(() => {
    void blocksOf(source).then((workspace) => (blocks.value = workspace));
  }, []);
  return (
    <div class="lesson-example">
      {blocks.value && (
        // The text says the same.
        <div aria-hidden="true">
          <DrawnBlocks workspace={blocks.value} text={source} />
        </div>
      )}
      {children}
    </div>
  );
}

function OpenButton({ open }: { open: () => void }) {
  return (
    <button type="button" class="button bordered" onClick={open}>
      <Icon name="examples" />
      {t("page-help-open-example")}
    </button>
  );
}

function Table({ table, props, depth }: { table: Tokens.Table; props: Props; depth: number }) {
  return (
    <table>
      <thead>
        <tr>
          {table.header.map((cell, index) => (
            <th key={index}>{shown(cell.tokens, props, depth)}</th>
          ))}
        </tr>
      </thead>
      <tbody>
        {table.rows.map((row, index) => (
          <tr key={index}>
            {row.map((cell, column) => (
              <td key={column}>{shown(cell.tokens, props, depth)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** A picture of the lesson; of any other, only its words. */
function Picture({ image, props: { lesson, pictures } }: { image: Tokens.Image; props: Props }) {
  const file = PICTURE.exec(image.href)?.[1] ?? "";
  const address = pictures ? pictures[file] : file && lessonPicture(lesson, file);
  return address ? <img src={address} alt={image.text} /> : <em>{image.text}</em>;
}

function Link({ link, children }: { link: Tokens.Link; children: ComponentChildren }) {
  // A click must not lead away from the program.
  if (!/^https:\/\//.test(link.href)) return <>{children}</>;
  return (
    <a href={link.href} target="_blank" rel="noopener noreferrer">
      {children}
    </a>
  );
}

export function lessonPicture(lesson: string, file: string): string {
  return `lessons/${encodeURIComponent(lesson)}/pictures/${encodeURIComponent(file)}`;
}
