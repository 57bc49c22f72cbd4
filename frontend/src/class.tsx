/** The entry point of a class's pages: joining, the teacher's wall, the projector. */

import { render } from "preact";

import { begin } from "./app/begin";
import { handInAt } from "./features/class-page/hand-in-address";
import { JoinPage } from "./features/class-page/join";
import { Joining } from "./features/class-page/joining";
import { ProjectorPage } from "./features/class-page/projector";
import { ClassStream } from "./features/class-page/stream";
import { WallPage } from "./features/class-page/wall";
import { HandInsPage } from "./features/hand-ins/page";
import { HandInStream } from "./features/hand-ins/stream";
import { RecordPage } from "./features/record/page";
import "./ui/theme.css";
import "./ui/controls.css";
import "./features/class-page/class-page.css";
import "./features/class-page/wall.css";

function pageAt(path: string) {
  if (path.endsWith("/teacher")) return <WallPage stream={new ClassStream("wall")} />;
  if (path.endsWith("/hand-ins")) return <HandInsPage stream={new HandInStream(handInAt(location.hash))} />;
  if (path.endsWith("/record")) return <RecordPage />;
  if (path.endsWith("/projector")) return <ProjectorPage stream={new ClassStream("projected")} />;
  return <JoinPage joining={new Joining(new URLSearchParams(location.search).get("word") ?? "")} />;
}

async function show(root: HTMLElement): Promise<void> {
  await begin();
  render(pageAt(location.pathname), root);
}

void show(document.getElementById("page")!);
