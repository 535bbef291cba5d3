import { el, fill } from "../dom";
import type { Operator } from "../engine/protocol";
import { localised, t } from "../i18n";
import { Dialog } from "./dialog";

/** Whether an operator is meant by what a person typed into the search field. */
export function matches(operator: Operator, wanted: string): boolean {
  const plain = (text: string): string => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
  const all = plain([operator.name, ...operator.aliases, operator.group, operator.summary, operator.help].join(" "));
  return plain(wanted)
    .split(/\s+/)
    .every((word) => all.includes(word));
}

export interface FunctionsEvents {
  catalogue(): Promise<Operator[] | null>;
  use(example: string): void;
}

/** Every function of the catalogue, searchable. */
export class Functions {
  private readonly dialog = new Dialog("functions", "functions");
  readonly root = this.dialog.root;
  private readonly search = el("input", { type: "search", spellcheck: false });
  private readonly list = el("div", { class: "operators" });
  private operators: Operator[] = [];

  constructor(private readonly events: FunctionsEvents) {
    this.search.addEventListener("input", () => this.paint());
    localised(() => {
      this.search.placeholder = t("functionsSearch");
      this.search.setAttribute("aria-label", t("functionsSearch"));
    });
  }

  async show(): Promise<void> {
    this.operators = (await this.events.catalogue()) ?? [];
    this.paint();
    this.dialog.show(this.search, this.list);
    this.search.focus();
  }

  private paint(): void {
    const found = this.operators.filter((operator) => matches(operator, this.search.value));
    const sections = [...new Set(found.map((operator) => operator.group))].flatMap((group) => [
      el("h3", {}, group),
      ...found.filter((operator) => operator.group === group).map((operator) => this.entry(operator)),
    ]);
    fill(this.list, ...(sections.length > 0 ? sections : [el("p", { class: "muted" }, t("functionsNone"))]));
  }

  private entry(operator: Operator): HTMLElement {
    const use = el("button", { type: "button", class: "quiet" }, t("insertExample"));
    use.addEventListener("click", () => {
      this.dialog.close();
      this.events.use(operator.example);
    });
    const parameters = operator.parameters.map((parameter) => [
      el("dt", {}, parameter.name, parameter.optional ? el("i", {}, ` ${t("optional")}`) : null),
      el("dd", {}, parameter.help, " ", el("span", { class: "muted" }, parameter.detail)),
    ]);
    const aliases = operator.aliases.length > 0 ? ` · ${operator.aliases.join(", ")}` : "";
    return el(
      "details",
      { class: "operator" },
      el("summary", {}, el("b", {}, operator.name), el("span", { class: "muted" }, aliases), el("span", { class: "summary" }, operator.summary)),
      el("code", {}, operator.signature),
      el("p", {}, operator.help),
      parameters.length > 0 ? el("dl", {}, ...parameters.flat()) : null,
      operator.example ? el("p", { class: "example" }, el("span", {}, `${t("example")} `), el("code", {}, operator.example), use) : null,
    );
  }
}
