// A notebook read from a disk, file://, would be shown as text: there it is taken from the script beside it, and saved.
"use strict";

function saveNotebook(name, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "application/x-ipynb+json" }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

document.addEventListener("click", (event) => {
  const link = event.target.closest(".notebook-links a[download]");
  if (location.protocol !== "file:" || !link?.pathname.endsWith(".ipynb")) return;
  event.preventDefault();
  const script = document.createElement("script");
  script.src = `${link.href}.js`;
  script.onload = () => script.remove();
  document.head.append(script);
});
