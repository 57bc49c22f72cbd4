/** Why did the robot do that? Questions about the run, and answers whose facts lead to their moments. */

import { useSignal, useSignalEffect } from "@preact/signals";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Asked, WhyAnswer, WhySentence } from "../../protocol/messages";
import { parted, questionInView, sentenceInView } from "./in-view";
import "./why.css";

/** Kinds of questions, in the order in which they are listed; the lines are asked for by their blocks. */
const GROUPS = [
  {
    title: "page-why-happened",
    kinds: [
      "goal",
      "reached",
      "game",
      "score",
      "lives",
      "bump",
      "end",
      "now",
      "movement",
      "emotion",
      "skill",
      "when",
      "print",
    ],
  },
  { title: "page-why-did-not", kinds: ["not-end", "not-movement", "not-skill", "not-when", "not-print"] },
  { title: "page-why-values", kinds: ["value"] },
  { title: "page-why-lines", kinds: ["line", "not-line"] },
] as const;

export function Why() {
  const { context, views, askingWhy } = usePage();
  useSignalEffect(() => {
    // The questions are those of the run so far.
    if (views.showsPanel("why") && context.running.timeline.value?.end && !askingWhy.isUsed) askingWhy.read();
  });
  const answer = askingWhy.answer.value;
  if (answer) return <Answer answer={answer} />;
  const questions = askingWhy.questions.value;
  return questions?.length ? <Questions questions={questions} /> : <p class="why-none">{t("page-why-none")}</p>;
}

function Questions({ questions }: { questions: readonly Asked[] }) {
  const page = usePage();
  const wanted = useSignal("");
  const found = questions.filter((one) =>
    say(questionInView(page, one)).toLowerCase().includes(wanted.value.toLowerCase()),
  );
  return (
    <div class="why" data-selectable>
      <label class="why-search">
        <span class="hidden">{t("page-why-search")}</span>
        <input
          type="search"
          placeholder={t("page-why-search")}
          value={wanted.value}
          onInput={({ currentTarget }) => (wanted.value = currentTarget.value)}
        />
      </label>
      {GROUPS.map(({ title, kinds }) => (
        <Group
          key={title}
          title={title}
          questions={found.filter(({ question }) => (kinds as readonly string[]).includes(question.ask))}
        />
      ))}
    </div>
  );
}

function Group({ title, questions }: { title: string; questions: readonly Asked[] }) {
  const page = usePage();
  const { askingWhy } = page;
  if (!questions.length) return null;
  return (
    <section>
      <h3>{t(title)}</h3>
      <ul>
        {questions.map((one) => (
          <li key={JSON.stringify(one.question)}>
            <button type="button" class="why-question" onClick={() => askingWhy.ask(one.question)}>
              {say(questionInView(page, one))}
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Answer({ answer }: { answer: WhyAnswer }) {
  const page = usePage();
  const { askingWhy } = page;
  const opened = useSignal(false);
  const { asked, sentences = [], more = [] } = answer;
  return (
    <div class="why" data-selectable>
      <button type="button" class="button" onClick={() => askingWhy.read()}>
        {t("page-why-back")}
      </button>
      <h3>{say(questionInView(page, asked))}</h3>
      <ol class="why-answer" aria-live="polite">
        {[...sentences, ...(opened.value ? more : [])].map((one, index, all) => (
          <Sentence key={JSON.stringify(one)} sentence={one} isThere={all[index - 1]?.time === one.time} />
        ))}
      </ol>
      {more.length > 0 && !opened.value && (
        <button type="button" class="button" onClick={() => (opened.value = true)}>
          {t("page-why-more", { count: more.length })}
        </button>
      )}
      {askingWhy.isAboutMoment.value && <Others questions={askingWhy.questions.value ?? []} than={asked} />}
    </div>
  );
}

/** What else can be asked about this moment. */
function Others({ questions, than }: { questions: readonly Asked[]; than: Asked }) {
  const same = JSON.stringify(than.question);
  return (
    <Group title="page-why-moment" questions={questions.filter(({ question }) => JSON.stringify(question) !== same)} />
  );
}

/** Words of a sentence; those of a block mark it. */
function Part({ text, block }: { text: string; block?: string }) {
  const { views } = usePage();
  if (!block) return <>{text}</>;
  const mark = () => views.reveal(block);
  return (
    <button type="button" class="why-link why-named" onClick={mark} onFocus={mark}>
      {text}
    </button>
  );
}

/** A fact, and the way to its block and to its moment, unless the sentence before `isThere` already. */
function Sentence({ sentence, isThere }: { sentence: WhySentence; isThere: boolean }) {
  const page = usePage();
  const { lookingBack, views } = page;
  const { time, block } = sentence;
  const shown = sentenceInView(page, sentence);
  const parts = parted(say(shown.phrase), shown);
  const isNamed = parts.some((part) => part.block === block);
  return (
    <li>
      {parts.map((part) => (
        <Part key={part.text} {...part} />
      ))}{" "}
      {time !== undefined && time !== null && !isThere && (
        <button type="button" class="why-link" onClick={() => lookingBack.look(time)}>
          {t("page-why-look", { seconds: time.toFixed(2) })}
        </button>
      )}{" "}
      {block && !isNamed && (
        <button type="button" class="why-link" onClick={() => views.reveal(block)}>
          {t("page-why-block")}
        </button>
      )}
    </li>
  );
}
