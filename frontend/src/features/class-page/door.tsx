/** The form with which children come in: on one page, or on a phone one question after the other. */

import { type Signal, useComputed, useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { Icon } from "../../ui/icons";
import { isNarrow } from "../../ui/screen";
import { type Joining, LENGTH, type Missing } from "./joining";
import { ALL, PinPicture, pictureColor, pictureName } from "./pictures";

/** The questions in their order. */
const STEPS = ["word", "name", "pictures"] as const;
type Step = (typeof STEPS)[number];

export function Door({ joining }: { joining: Joining }) {
  const form = useRef<HTMLFormElement>(null);
  const step = useSignal<Step>(joining.word.peek() ? "name" : "word");
  const small = isNarrow.value;
  const isAsked = (name: Step) => !small || step.value === name;
  const goOn = async () => {
    const missing = joining.missing.peek();
    if (small && step.peek() === "word" && missing !== "word") {
      if (await joining.tryWord()) step.value = "name";
    } else if (missing) focus(form.current, missing);
    else await joining.join();
  };
  useFocus(form, joining, step);
  return (
    <form
      ref={form}
      class="join-form"
      noValidate
      onSubmit={(event) => {
        event.preventDefault();
        void goOn();
      }}
    >
      <Head joining={joining} step={step.value} back={() => (step.value = previous(step.peek()))} />
      <div class="join-fields">
        {isAsked("word") && <Word joining={joining} />}
        {isAsked("name") && <Name joining={joining} />}
      </div>
      {isAsked("name") && <Whether joining={joining} known={() => (step.value = "pictures")} />}
      {isAsked("pictures") && <Pictures joining={joining} form={form} />}
      <footer>
        <Problem joining={joining} />
        {(!small || step.value !== "name") && <Go joining={joining} isLast={isAsked("pictures")} />}
      </footer>
    </form>
  );
}

function previous(step: Step): Step {
  return STEPS[STEPS.indexOf(step) - 1] ?? "word";
}

function focus(form: HTMLFormElement | null, place: Missing): void {
  form?.querySelector<HTMLElement>(`[data-asks=${place}]`)?.focus();
}

/** The focus is where one types: at the beginning, at each question, and where something was wrong. */
function useFocus(form: { current: HTMLFormElement | null }, joining: Joining, step: Signal<Step>): void {
  useLayoutEffect(() => focus(form.current, joining.missing.peek() ?? "word"), []);
  useEffect(() => void joining.tryWord(), []);
  useLayoutEffect(() => {
    if (isNarrow.peek()) focus(form.current, step.value);
  }, [step.value]);
  const wrong = joining.wrong.value;
  useLayoutEffect(() => {
    if (!wrong) return;
    step.value = wrong === "whether" ? "name" : wrong;
    focus(form.current, wrong);
  }, [joining.problem.value]);
}

interface HeadProps {
  readonly joining: Joining;
  readonly step: Step;
  readonly back: () => void;
}

function Head({ joining, step, back }: HeadProps) {
  const { title } = joining.about.value!;
  if (!isNarrow.value) {
    return (
      <header>
        <h1>{t("page-class-join", { title })}</h1>
        <p class="dim">{t("page-class-join-text")}</p>
      </header>
    );
  }
  const name = joining.name.value.trim();
  return (
    <header>
      <p class="join-class">
        {t("page-class-title", { title })}
        <span>{t("page-class-join-step", { step: STEPS.indexOf(step) + 1 })}</span>
      </p>
      {step !== "word" && (
        <button type="button" class="button" aria-label={t("page-class-back")} onClick={back}>
          <Icon name="previous" />
        </button>
      )}
      <h1>{step === "pictures" ? t("page-class-hello", { name }) : t("page-class-join", { title })}</h1>
    </header>
  );
}

interface FieldProps {
  readonly asks: "word" | "name";
  readonly joining: Joining;
  readonly isRight: boolean;
  readonly longest: number;
  readonly example?: string;
  readonly typed?: () => void;
}

function Field({ asks, joining, isRight, longest, example, typed }: FieldProps) {
  return (
    <label class={isRight ? "join-field right" : "join-field"}>
      <span>{t(`page-class-${asks}`)}</span>
      <input
        name={asks}
        data-asks={asks}
        dir="auto"
        autocomplete="off"
        autocapitalize={asks === "word" ? "none" : undefined}
        spellcheck={false}
        placeholder={example}
        maxLength={longest}
        aria-invalid={joining.wrong.value === asks}
        value={joining[asks].value}
        onInput={({ currentTarget }) => joining.type(asks, currentTarget.value)}
        onChange={typed}
      />
      {isRight && <Icon name="check" />}
    </label>
  );
}

function Word({ joining }: { joining: Joining }) {
  return (
    <Field
      asks="word"
      joining={joining}
      isRight={joining.isKnownWord.value}
      example="koala 47"
      longest={60}
      typed={() => void joining.tryWord()}
    />
  );
}

function Name({ joining }: { joining: Joining }) {
  const isRight = joining.name.value.trim() !== "" && joining.wrong.value !== "name";
  return <Field asks="name" joining={joining} isRight={isRight} longest={200} />;
}

/** Whether the pupil is new: a phone goes on at once. */
function Whether({ joining, known }: { joining: Joining; known: () => void }) {
  const { isNew } = joining;
  const small = isNarrow.value;
  const hasName = joining.name.value.trim() !== "";
  const choose = (value: boolean) => {
    isNew.value = value;
    if (small && value) void joining.join();
    else if (small) known();
  };
  return (
    <div class="join-whether" role="group" aria-label={t("page-class-whether")}>
      {joining.about.value!.open && (
        <button
          type="button"
          data-asks="whether"
          aria-pressed={isNew.value === true}
          disabled={small && !hasName}
          onClick={() => choose(true)}
        >
          {t("page-class-new")}
        </button>
      )}
      <button
        type="button"
        aria-pressed={isNew.value === false}
        disabled={small && !hasName}
        onClick={() => choose(false)}
      >
        {t("page-class-known")}
      </button>
    </div>
  );
}

/** The four pictures of a pupil who has been here, numbered as they are tapped. */
function Pictures({ joining, form }: { joining: Joining; form: { current: HTMLFormElement | null } }) {
  const chosen = joining.pictures.value;
  const isWhole = useComputed(() => joining.pictures.value.length === LENGTH);
  // The next key joins, and does not take the last picture back.
  useLayoutEffect(() => {
    if (isWhole.value) form.current?.querySelector<HTMLElement>(".join-go")?.focus();
  }, [isWhole.value]);
  if (joining.isNew.value !== false) return <p class="join-given">{joining.isNew.value && t("page-class-given")}</p>;
  return (
    <section class="join-pictures" aria-labelledby="join-pictures">
      <h2 id="join-pictures">{t("page-class-pictures")}</h2>
      <p class="join-chosen" role="status">
        {Array.from({ length: LENGTH }, (_, i) => {
          const picture = chosen[i];
          return picture ? <PinPicture key={i} picture={picture} /> : <span key={i}>{i + 1}</span>;
        })}
        <span class="hidden">{t("page-class-chosen", { count: chosen.length })}</span>
      </p>
      <button
        type="button"
        class="button"
        aria-label={t("page-class-take-back")}
        title={t("page-class-take-back")}
        aria-disabled={chosen.length === 0}
        onClick={() => joining.back()}
      >
        <Icon name="undo" />
      </button>
      <div class="pin-keys">
        {ALL.map((picture, index) => {
          const place = chosen.indexOf(picture) + 1;
          return (
            <button
              key={picture}
              type="button"
              class="pin-tile"
              style={pictureColor(picture)}
              data-asks={index === 0 ? "pictures" : undefined}
              aria-pressed={place > 0}
              onClick={() => joining.press(picture)}
            >
              <PinPicture picture={picture} />
              {pictureName(picture)}
              {place > 0 && <i>{place}</i>}
            </button>
          );
        })}
      </div>
    </section>
  );
}

function Problem({ joining }: { joining: Joining }) {
  const problem = joining.problem.value;
  const name = joining.name.value.trim();
  return (
    <div class="join-problem">
      <p role="alert">{problem && say(problem)}</p>
      {problem?.code === "class-only-first-name" && (
        <button type="button" class="button bordered" onClick={() => void joining.join(true)}>
          {t("page-class-is-first-name", { name })}
        </button>
      )}
      {!problem && joining.isNew.value === false && <p class="dim">{t("page-class-forgotten")}</p>}
    </div>
  );
}

/** It says how many pictures are missing, and leads to what is missing. */
function Go({ joining, isLast }: { joining: Joining; isLast: boolean }) {
  const more = LENGTH - joining.pictures.value.length;
  const isOff = isLast ? joining.missing.value !== null : joining.missing.value === "word";
  const text = isLast ? t("page-class-join-do") : t("page-class-next");
  return (
    <button type="submit" class="join-go" aria-disabled={isOff}>
      {!isOff && <Icon name="next" />}
      {isLast && joining.isNew.value === false && more > 0 ? t("page-class-join-more", { count: more }) : text}
    </button>
  );
}
