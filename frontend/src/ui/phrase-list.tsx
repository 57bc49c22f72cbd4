/** A list of what the server says, with a title; nothing if it is empty. */

import { type Phrase, say } from "../i18n";
import "./phrase-list.css";

export function PhraseList({ title, phrases }: { title: string; phrases: readonly Phrase[] }) {
  if (phrases.length === 0) return null;
  return (
    <section class="phrase-list">
      <h3>{title}</h3>
      <ul>
        {phrases.map((phrase) => (
          <li key={say(phrase)}>{say(phrase)}</li>
        ))}
      </ul>
    </section>
  );
}
