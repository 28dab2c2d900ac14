// The six components: each maker gives a node, how to update it, and how to fit its text.
// Texts are always set as text, never read as markup.

import { colour, isLight } from "./colours.js";
import { element } from "./element.js";
import { balance, fit, write } from "./fit.js";
import { input } from "./input.js";
import { measure } from "./measures.js";

function text() {
  const node = element("div", "text");
  const inner = element("span", "", node);
  return {
    node,
    update(component) {
      node.style.color = colour(component.color);
      const size = component.size ?? measure("text-size");
      node.dataset.rank = size >= measure("title-from") ? "title" : size >= measure("body-from") ? "body" : "hint";
    },
    fit: (component, unit) => fit(node, inner, (component.size ?? measure("text-size")) * unit, component.parts),
    balance: () => balance(node, inner),
  };
}

function button(say) {
  const node = element("button", "button");
  node.type = "button";
  const inner = element("span", "", node);
  let shown = null;
  node.addEventListener("click", (event) => {
    if (!say.isSecondTap(event)) say.use(shown.id, {});
  });
  return {
    node,
    update(component) {
      shown = component;
      node.style.color = colour(component.color);
      node.dataset.look = component.fill ? "given" : component.first ? "filled" : "outlined";
    },
    fit(component, unit) {
      node.classList.toggle("on-light", Boolean(component.fill) && !component.color && isLight(node));
      fit(node, inner, (component.size ?? measure("button-size")) * unit, component.parts);
    },
    balance: () => balance(node, inner),
  };
}

function image() {
  const node = element("div", "image");
  const picture = element("img", "", node);
  picture.alt = "";
  picture.draggable = false;
  picture.addEventListener("error", () => node.classList.add("missing"));
  picture.addEventListener("load", () => node.classList.remove("missing"));
  return {
    node,
    update(component) {
      if (picture.getAttribute("src") !== component.src) picture.setAttribute("src", component.src);
    },
  };
}

function movie(say) {
  const node = element("div", "movie");
  const video = element("video", "", node);
  video.playsInline = true;
  video.preload = "auto";
  let action = null;
  const end = (error) => {
    if (action === null) return;
    const ended = action;
    action = null;
    say.ended(ended, error);
  };
  video.addEventListener("ended", () => end(null));
  video.addEventListener("error", () => {
    node.classList.add("missing");
    end("the page can not play this movie");
  });
  const play = async () => {
    try {
      await video.play();
    } catch (refusal) {
      // Browsers that nobody has touched yet play without sound only.
      if (refusal.name !== "NotAllowedError" || video.muted) return;
      video.muted = true;
      addEventListener("pointerdown", () => { video.muted = false; }, { once: true });
      video.play().catch(() => {});
    }
  };
  let played = null;
  return {
    node,
    update(component) {
      const fresh = video.getAttribute("src") !== component.src;
      if (fresh) {
        node.classList.remove("missing");
        video.setAttribute("src", component.src);
      }
      if (component.action !== undefined && component.action !== played) {
        played = action = component.action;
        if (!fresh) video.currentTime = 0;
        play();
      } else if (fresh) {
        play();
      }
    },
    remove() {
      action = null;
      video.pause();
      video.removeAttribute("src");
      video.load();
    },
  };
}

function list(say) {
  const node = element("div", "list");
  node.setAttribute("role", "listbox");
  let shown = null;
  let known = "";
  const mark = () => {
    node.classList.toggle("more-above", node.scrollTop > 4);
    node.classList.toggle("more-below", node.scrollTop + node.clientHeight < node.scrollHeight - 4);
  };
  node.addEventListener("scroll", mark, { passive: true });
  return {
    node,
    update(component) {
      shown = component;
      node.style.color = colour(component.color);
      const now = JSON.stringify(component.items);
      if (now === known) return;
      known = now;
      const rows = component.items.map((label, number) => {
        const row = element("button", "item");
        row.type = "button";
        row.setAttribute("role", "option");
        write(element("span", "", row), label);
        row.addEventListener("click", () => {
          for (const other of rows) other.setAttribute("aria-selected", String(other === row));
          say.use(shown.id, { item: number });
        });
        return row;
      });
      node.replaceChildren(...rows);
    },
    fit(component, unit) {
      node.style.fontSize = `${Math.max(measure("least"), (component.size ?? measure("list-size")) * unit)}px`;
      mark();
    },
  };
}

export const makers = { text, button, image, movie, input, list };
