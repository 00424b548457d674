"use strict";

{
  const data = JSON.parse(document.getElementById("data").textContent);
  if (data.panels?.length) drawCurves(data.panels, document.getElementById("panels"), data.day);
  if (data.lumen) lumenOf(data.lumen).then((lumen) => new LumenSection(lumen));
}
