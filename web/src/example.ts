import scene from "virtual:example-case";
import { submitCase } from "./api.ts";
import { h } from "./dom.ts";
import { problemBox } from "./problem_box.ts";
import { jobHref } from "./route.ts";

/** A button that submits the study's section 3.1 with the 8 d0 thrombus, and opens the job. */
export function exampleButton(): HTMLElement {
  const failure = h("div");
  const button = h("button", { type: "button", class: "primary" }, "Run the example");
  button.addEventListener("click", async () => {
    button.disabled = true;
    try {
      location.hash = jobHref((await submitCase(scene)).id);
    } catch (problem) {
      failure.replaceChildren(problemBox(problem));
    } finally {
      button.disabled = false;
    }
  });
  return h("div", { class: "example" }, button, failure);
}
