import { el, fill, freshId, show } from "../dom";
import type { Assistance, Operator } from "../engine/protocol";
import { t } from "../i18n";

const SHOWN = 9;

/** The list of completions under the formula, and the card that explains the call around the caret. */
export class Completion {
  readonly id = freshId("completions");
  private readonly list = el("ul", { id: this.id, class: "proposals", role: "listbox" });
  private readonly card = el("div", { class: "call-card" });
  readonly root = el("div", { class: "assist", hidden: true }, this.list, this.card);
  private answer: Assistance | null = null;
  private active = 0;

  constructor(private readonly choose: (index: number) => void) {
    this.root.addEventListener("mousedown", (event) => {
      event.preventDefault();
      const item = (event.target as Element).closest<HTMLElement>("li[data-index]");
      if (item) this.choose(Number(item.dataset["index"]));
    });
  }

  /** Whether a proposal can be taken now. */
  get open(): boolean {
    return !this.root.hidden && (this.answer?.proposals.length ?? 0) > 0;
  }

  get activeId(): string | null {
    return this.open ? `${this.id}-${this.active}` : null;
  }

  get activeIndex(): number {
    return this.active;
  }

  show(answer: Assistance): void {
    this.answer = answer;
    this.active = 0;
    this.root.hidden = answer.proposals.length === 0 && !answer.call;
    this.paint();
  }

  hide(): void {
    show(this.root, false);
    this.answer = null;
  }

  move(step: number): void {
    const count = Math.min(this.answer?.proposals.length ?? 0, SHOWN);
    if (count === 0) return;
    this.active = (this.active + step + count) % count;
    this.paint();
  }

  /** What the chosen proposal puts in place of which part of the text. */
  taken(index: number): { from: number; to: number; insert: string } | null {
    const proposal = this.answer?.proposals[index];
    if (!proposal || !this.answer) return null;
    return { from: this.answer.from, to: this.answer.to, insert: proposal.insert };
  }

  private paint(): void {
    const { proposals, call } = this.answer ?? { proposals: [], call: null };
    this.list.setAttribute("aria-label", t("proposals"));
    this.list.hidden = proposals.length === 0;
    fill(this.list, ...proposals.slice(0, SHOWN).map((proposal, index) => this.item(proposal, index)));
    const explained = proposals.length === 0 ? call : null;
    this.card.hidden = !explained;
    fill(this.card, ...(explained ? callCard(explained.operator, explained.argument) : []));
  }

  private item(proposal: Assistance["proposals"][number], index: number): HTMLElement {
    const item = el(
      "li",
      { id: `${this.id}-${index}`, role: "option", data: { index: String(index) } },
      el("span", { class: "proposal-name" }, proposal.name),
      el("span", { class: "proposal-summary" }, proposal.summary),
    );
    item.setAttribute("aria-selected", String(index === this.active));
    return item;
  }
}

/** The signature with the present argument set off, and its help. */
export function callCard(operator: Operator, argument: number): HTMLElement[] {
  const last = operator.parameters.length - 1;
  const active = operator.parameters[last]?.variadic ? Math.min(argument, last) : argument;
  const parts: (HTMLElement | string)[] = [el("b", {}, operator.name), "("];
  operator.parameters.forEach((parameter, index) => {
    if (index > 0) parts.push(", ");
    const name = parameter.variadic ? `${parameter.name}…` : parameter.name;
    const shown = parameter.optional ? `[${name}]` : name;
    parts.push(el("span", { class: index === active ? "active" : "" }, shown));
  });
  parts.push(")");
  const present = operator.parameters[active];
  return [
    el("div", { class: "signature" }, ...parts),
    el("div", { class: "summary" }, operator.summary),
    ...(present ? [el("div", { class: "argument" }, el("b", {}, present.name), ` ${present.help} `, el("i", {}, present.detail))] : []),
  ];
}
