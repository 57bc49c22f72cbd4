/** The page on which children come in: word, name, pictures. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { Icon } from "../../ui/icons";
import { Frame } from "./frame";
import { type Joining, LENGTH } from "./joining";
import { ALL, PictureRow, PinPicture, pictureName } from "./pictures";

type Step = "word" | "who" | "pictures";

/** Where to put right what was typed. */
const WRONG: Readonly<Partial<Record<string, Step>>> = {
  "class-wrong-word": "word",
  "class-no-name": "who",
  "class-hidden-character": "who",
  "class-name-taken": "who",
};

export function JoinPage({ joining }: { joining: Joining }) {
  const about = joining.about.value;
  useEffect(() => void joining.load(), []);
  if (!about) return <Frame />;
  const title = t("page-class-title", { title: about.title });
  return (
    <Frame title={title}>
      {joining.joined.value?.pictures ? (
        <Remember joining={joining} />
      ) : about.pupil ? (
        <Again joining={joining} />
      ) : (
        <Door joining={joining} open={about.open} />
      )}
    </Frame>
  );
}

function Again({ joining }: { joining: Joining }) {
  const about = joining.about.value!;
  return (
    <section class="class-card">
      <h2>{t("page-class-hello", { name: about.pupil })}</h2>
      <a class="button filled big" href={about.address}>
        <Icon name="run" />
        {t("page-class-go-on")}
      </a>
      <button type="button" class="button" onClick={() => void joining.leave()}>
        {t("page-class-not-me", { name: about.pupil })}
      </button>
    </section>
  );
}

function Door({ joining, open }: { joining: Joining; open: boolean }) {
  const step = useSignal<Step>("word");
  const problem = joining.problem.value;
  // A wrong word or name is put right where it was typed.
  const shown = (problem && WRONG[problem.code]) || step.value;
  const go = (next: Step) => {
    joining.problem.value = null;
    step.value = next;
  };
  return (
    <section class="class-card">
      <p role="alert" class={problem ? "class-problem" : "hidden"}>
        {problem && say(problem)}
      </p>
      {shown === "word" && <Word joining={joining} next={() => go("who")} />}
      {shown === "who" && <Who joining={joining} open={open} next={() => go("pictures")} back={() => go("word")} />}
      {shown === "pictures" && <Pictures joining={joining} back={() => go("who")} />}
    </section>
  );
}

/** A reference to a field that has the focus as soon as it is shown. */
function useFocused() {
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.focus(), []);
  return field;
}

function Word({ joining, next }: { joining: Joining; next: () => void }) {
  const field = useFocused();
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        next();
      }}
    >
      <label class="class-field">
        {t("page-class-word")}
        <input
          ref={field}
          name="word"
          required
          autocomplete="off"
          autocapitalize="none"
          spellcheck={false}
          placeholder="koala 47"
          maxLength={60}
          value={joining.word.value}
          onInput={({ currentTarget }) => (joining.word.value = currentTarget.value)}
        />
      </label>
      <button type="submit" class="button filled big">
        {t("page-class-next")}
      </button>
    </form>
  );
}

interface WhoProps {
  readonly joining: Joining;
  readonly open: boolean;
  readonly next: () => void;
  readonly back: () => void;
}

function Who({ joining, open, next, back }: WhoProps) {
  const field = useFocused();
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        next();
      }}
    >
      <label class="class-field">
        {t("page-class-name")}
        <input
          ref={field}
          name="name"
          required
          autocomplete="off"
          spellcheck={false}
          maxLength={200}
          value={joining.name.value}
          onInput={({ currentTarget }) => (joining.name.value = currentTarget.value)}
        />
      </label>
      <button type="submit" class="button filled big">
        {t("page-class-known")}
      </button>
      {open && (
        <button
          type="button"
          class="button bordered big"
          disabled={!joining.name.value.trim()}
          onClick={() => void joining.join(null)}
        >
          {t("page-class-new")}
        </button>
      )}
      <Back go={back} />
    </form>
  );
}

function Pictures({ joining, back }: { joining: Joining; back: () => void }) {
  const chosen = joining.pictures.value;
  return (
    <div>
      <h2>{t("page-class-pictures")}</h2>
      <p class="pin-chosen" role="status" aria-label={t("page-class-chosen", { count: chosen.length })}>
        {Array.from({ length: LENGTH }, (_, i) => (
          <span key={i} class={i < chosen.length ? "dot full" : "dot"} />
        ))}
      </p>
      <div class="pin-keys">
        {ALL.map((picture) => (
          <button
            key={picture}
            type="button"
            aria-label={pictureName(picture)}
            title={pictureName(picture)}
            onClick={() => void joining.add(picture)}
          >
            <PinPicture picture={picture} />
          </button>
        ))}
      </div>
      <Back go={chosen.length > 0 ? () => joining.back() : back} />
    </div>
  );
}

/** A new pupil learns the pictures by heart. */
function Remember({ joining }: { joining: Joining }) {
  const { pictures = [], address } = joining.joined.value!;
  return (
    <section class="class-card">
      <h2>{t("page-class-remember", { name: joining.name.value })}</h2>
      <p>{t("page-class-remember-text")}</p>
      <PictureRow pictures={pictures} />
      <a class="button filled big" href={address}>
        {t("page-class-remembered")}
      </a>
    </section>
  );
}

function Back({ go }: { go: () => void }) {
  return (
    <button type="button" class="button" onClick={go}>
      {t("page-class-back")}
    </button>
  );
}
