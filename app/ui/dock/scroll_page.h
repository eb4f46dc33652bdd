#pragma once

class QScrollArea;
class QWidget;

namespace app {

/// Returns an area in `panel` that scrolls up and down only. It takes no keyboard focus, as the texts in it do.
QScrollArea *makeScrollArea(QWidget &panel);

/// Returns a page to scroll in such an area, with the background of panels.
QWidget *makePage();

/// Lays out `panel` as a page: `text`, which scrolls, above `buttons`, which stay.
void layOutPage(QWidget &panel, QWidget *text, QWidget *buttons);

}
