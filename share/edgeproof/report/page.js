"use strict";
(() => {
  const root = document.documentElement;
  const byId = (id) => document.getElementById(id);

  // The theme: the system's until the reader chooses; remembered where the browser allows it.
  const button = byId("theme");
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const stored = (value) => {
    try {
      if (value === undefined) return localStorage.getItem("edgeproof-theme");
      localStorage.setItem("edgeproof-theme", value);
    } catch (_) { /* a page from a file may have no storage */ }
    return null;
  };
  const isDark = () => (root.dataset.theme || (system.matches ? "dark" : "light")) === "dark";
  const showTheme = () => {
    button.textContent = isDark() ? "Use light colours" : "Use dark colours"; // what a click does
  };
  const remembered = stored();
  if (remembered === "dark" || remembered === "light") root.dataset.theme = remembered;
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    stored(root.dataset.theme);
    showTheme();
  });
  system.addEventListener("change", showTheme);
  button.hidden = false;
  showTheme();

  // The filter. Its state is in the address: #verdict=refuted&text=gamma.
  const claims = Array.from(document.querySelectorAll("details.claim"));
  const form = byId("filter");
  const fields = { verdict: byId("filter-verdict"), section: byId("filter-section"), text: byId("filter-text") };
  const count = byId("filter-count");
  const openAll = byId("open-all");

  // The values that occur; verdicts in the order of the summary.
  const order = Array.from(document.querySelectorAll(".counts .verdict"), (mark) => mark.textContent);
  for (const name of ["verdict", "section"]) {
    const values = [...new Set(claims.map((claim) => claim.dataset[name]))].filter(Boolean);
    if (name === "verdict") values.sort((one, other) => order.indexOf(one) - order.indexOf(other));
    for (const value of values) fields[name].add(new Option(value, value));
  }

  const apply = () => {
    const words = fields.text.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const claim of claims) {
      const all = claim.textContent.toLowerCase();
      const fits = (!fields.verdict.value || claim.dataset.verdict === fields.verdict.value) &&
        (!fields.section.value || claim.dataset.section === fields.section.value) &&
        words.every((word) => all.includes(word));
      claim.hidden = !fits;
      if (fits) shown += 1;
    }
    count.textContent = shown + " of " + claims.length + " claims";
  };
  const remember = () => {
    const state = new URLSearchParams();
    for (const [name, field] of Object.entries(fields)) if (field.value) state.set(name, field.value);
    const text = state.toString();
    history.replaceState(null, "", text ? "#" + text : location.pathname + location.search);
  };
  const openClaim = (claim) => {
    if (claim.hidden) { form.reset(); apply(); }
    claim.open = true;
    claim.scrollIntoView();
    claim.querySelector("summary").focus({ preventScroll: true });
  };
  const follow = () => {
    const hash = location.hash.slice(1);
    if (hash.includes("=")) {
      const state = new URLSearchParams(hash);
      for (const [name, field] of Object.entries(fields)) field.value = state.get(name) || "";
      apply();
      byId("claims").scrollIntoView();
      return;
    }
    let target = null;
    try { target = hash && byId(decodeURIComponent(hash)); } catch (_) { /* no such name */ }
    if (target && target.matches("details.theorem")) target.open = true;
    const claim = target && target.closest("details.claim");
    if (claim) openClaim(claim);
    if (claim && claim !== target) target.scrollIntoView();
  };
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", () => { apply(); remember(); });
  form.addEventListener("reset", () => setTimeout(() => { apply(); remember(); }));
  openAll.addEventListener("click", () => {
    const open = claims.some((claim) => !claim.hidden && !claim.open);
    for (const claim of claims) if (!claim.hidden) claim.open = open;
    openAll.textContent = open ? "Close all" : "Open all";
  });
  window.addEventListener("hashchange", follow);
  form.hidden = false;
  apply();
  follow();

  // Browsers do not break formulas into lines. A formula is divided before its signs = + and -, and behind a
  // fraction if a part is too wide, into parts, between which a line may end: on every screen, on paper, and with every font. Only a
  // fraction that is wider than its place gets a stroke, with both its sides divided. Widths are in
  // px; `paper` is that of A4 or letter without margins, and `onPaper` the size of a formula on
  // paper compared with the screen.
  const paper = 600;
  const onPaper = 0.76;
  const narrow = 200;
  const sign = (text) => {
    const mo = document.createElementNS("http://www.w3.org/1998/Math/MathML", "mo");
    mo.setAttribute("stretchy", "false");
    mo.textContent = text;
    return mo;
  };
  const placeOf = (math) => {
    const block = math.closest("li, p, td, dd, .scroll, .said, .body, .erratum");
    return Math.min(paper / onPaper, block ? block.clientWidth : paper);
  };
  const tokensOf = (node, room) => {
    if (node.localName === "mrow" && !node.classList.contains("changed")) {
      return Array.from(node.children).flatMap((child) => tokensOf(child, room));
    }
    if (node.localName === "mfrac" && node.getBoundingClientRect().width > room) {
      const [over, under] = Array.from(node.children, (child) => tokensOf(child, room));
      return [sign("("), ...over, sign(")"), sign("/"), sign("("), ...under, sign(")")];
    }
    return [node];
  };
  const widthOf = (tokens) => tokens.reduce((sum, token) => sum + token.getBoundingClientRect().width, 0);
  // Parts that are too wide are divided again, within their brackets.
  const partsOf = (tokens, room, most = 0) => {
    const parts = [[]];
    let depth = 0;
    for (const token of tokens) {
      const before = parts.at(-1).at(-1);
      const ends = before && depth <= most;
      if (ends && /^[=+\u2212/]$/.test(token.textContent) && !/[=([]$/.test(before.textContent)) parts.push([]);
      if (ends && most > 0 && before.localName === "mfrac" && token.textContent === "(") parts.push([]);
      depth += token.textContent.split("(").length - token.textContent.split(")").length; // also in ")^2"
      parts.at(-1).push(token);
    }
    if (most >= 3) return parts;
    return parts.flatMap((part) => (widthOf(part) > room ? partsOf(part, room, most + 1) : [part]));
  };
  const divide = (math) => {
    if (math.getBoundingClientRect().width <= narrow) return;
    const room = placeOf(math);
    const tokens = Array.from(math.children).flatMap((child) => tokensOf(child, room));
    const grows = tokens.some((token) => !token.isConnected) ? 0.65 : 1; // the sides of a fraction are smaller
    const parts = partsOf(tokens, room * grows);
    for (const [first] of parts.slice(1)) if (first.localName === "mo") first.setAttribute("form", "infix");
    if (parts.length < 2) return;
    const lines = document.createElement("span");
    if (math.getAttribute("display") === "block") lines.className = "lines";
    lines.setAttribute("role", "math");
    lines.setAttribute("aria-label", math.getAttribute("aria-label") || math.textContent);
    for (const part of parts) {
      const piece = math.cloneNode(false);
      for (const name of ["display", "aria-label"]) piece.removeAttribute(name);
      piece.setAttribute("displaystyle", String(math.getAttribute("display") === "block"));
      piece.append(...part);
      if (lines.firstChild) lines.append(document.createElement("wbr"));
      lines.append(piece);
    }
    math.replaceWith(lines);
  };
  const divideIn = (place) => {
    for (const math of place.querySelectorAll("math")) {
      if (!math.closest("[role=math]")) divide(math);
    }
  };
  for (const place of document.querySelectorAll("#errata, #doubtful, .claim > summary")) divideIn(place);
  const divideWhenOpen = (claim) => {
    if (!claim.open || claim.dataset.divided) return;
    claim.dataset.divided = "yes";
    divideIn(claim);
  };
  for (const claim of claims) {
    divideWhenOpen(claim);
    claim.addEventListener("toggle", () => divideWhenOpen(claim));
  }

  // On paper the errata, or everything, opened, and shut again afterwards. A formula that is still
  // too long becomes smaller.
  const whole = byId("print-all");
  whole.parentElement.hidden = false;
  whole.addEventListener("change", () => {
    if (whole.checked) root.dataset.print = "all";
    else delete root.dataset.print;
  });
  let shut = [];
  let fitted = [];
  window.addEventListener("beforeprint", () => {
    shut = whole.checked ? claims.filter((claim) => !claim.open) : [];
    for (const claim of shut) claim.open = true;
    claims.forEach(divideWhenOpen);
    fitted = Array.from(document.querySelectorAll("math"))
      .map((math) => [math, paper / (math.getBoundingClientRect().width * onPaper)])
      .filter(([, fit]) => fit < 1);
    for (const [math, fit] of fitted) math.style.setProperty("--fit", fit.toFixed(3));
  });
  window.addEventListener("afterprint", () => {
    for (const claim of shut) claim.open = false;
    for (const [math] of fitted) math.style.removeProperty("--fit");
  });

  // A line of LaTeX to the clipboard; where there is none, it is selected.
  for (const copy of document.querySelectorAll(".copy-button")) {
    const line = copy.parentElement.querySelector("code");
    const words = copy.firstChild.textContent;
    copy.hidden = false;
    copy.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(line.textContent);
        copy.firstChild.textContent = "Copied";
      } catch (_) {
        getSelection().selectAllChildren(line);
        copy.firstChild.textContent = "Selected";
      }
      setTimeout(() => { copy.firstChild.textContent = words; }, 2000);
    });
  }
})();
