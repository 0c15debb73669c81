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
    button.textContent = isDark() ? "Light" : "Dark"; // the theme that a click selects
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

  // The filter. Its state is in the address: #verdict=refuted&section=s3&text=gamma.
  const claims = Array.from(document.querySelectorAll("details.claim"));
  const form = byId("filter");
  const fields = { verdict: byId("filter-verdict"), section: byId("filter-section"), text: byId("filter-text") };
  const count = byId("filter-count");
  const openAll = byId("open-all");

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
    if (target && target.matches("details.claim")) openClaim(target);
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

  // Browsers do not break formulas into lines. A long formula is divided before its signs + and -
  // into parts, between which a line may end. Widths are in px; `paper` is that of A4 or letter
  // without margins, and `onPaper` the size of a formula on paper compared with the screen.
  const paper = 630;
  const onPaper = 0.76;
  const sign = (text) => {
    const mo = document.createElementNS("http://www.w3.org/1998/Math/MathML", "mo");
    mo.setAttribute("stretchy", "false");
    mo.textContent = text;
    return mo;
  };
  const tokensOf = (node) => {
    if (node.localName === "mrow" && !node.classList.contains("changed")) {
      return Array.from(node.children).flatMap(tokensOf);
    }
    if (node.localName === "mfrac" && node.getBoundingClientRect().width > paper) {
      const [over, under] = Array.from(node.children, tokensOf);
      return [sign("("), ...over, sign(")"), sign("/"), sign("("), ...under, sign(")")];
    }
    return [node];
  };
  const divide = (math) => {
    const parts = [[]];
    for (const token of Array.from(math.children).flatMap(tokensOf)) {
      const before = parts.at(-1).at(-1);
      if (/^[+\u2212]$/.test(token.textContent) && before && !/[([]$/.test(before.textContent)) {
        if (token.localName === "mo") token.setAttribute("form", "infix");
        parts.push([]);
      }
      parts.at(-1).push(token);
    }
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
      lines.append(piece, " ");
    }
    math.replaceWith(lines);
  };
  for (const math of document.querySelectorAll(".erratum math")) {
    if (math.getBoundingClientRect().width > Math.min(paper / onPaper, math.parentElement.clientWidth || paper)) divide(math);
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
