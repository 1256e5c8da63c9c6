import { Problem, type FieldError } from "./api.ts";
import { h } from "./dom.ts";
import { sentence } from "./format.ts";

/** The faults of a case, each with the place in it. */
export function faultList(faults: FieldError[]): HTMLElement {
  return h(
    "ul",
    {},
    ...faults.map((fault) => h("li", {}, h("code", {}, fault.pointer || "/"), ` ${fault.message}`)),
  );
}

/** What went wrong with a request, with every fault of a body that was refused. */
export function problemBox(failure: unknown): HTMLElement {
  const [title, detail] =
    failure instanceof Problem ? [failure.title, failure.detail] : ["Something went wrong", String(failure)];
  return h(
    "div",
    { class: "notice bad", role: "alert" },
    h("strong", {}, title),
    detail && h("p", {}, sentence(detail)),
    failure instanceof Problem && failure.errors.length > 0 && faultList(failure.errors),
  );
}
