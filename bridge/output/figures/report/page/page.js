"use strict";

{
  const data = JSON.parse(document.getElementById("data").textContent);
  if (data.panels?.length) drawCurves(data.panels, document.getElementById("panels"), data.day);
  const drawn = () => { document.body.dataset.drawn = "yes"; };
  if (data.lumen) lumenOf(data.lumen).then((lumen) => new LumenSection(lumen)).then(drawn);
  else drawn();
}
