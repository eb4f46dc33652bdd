#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QFrame>
#include <QTimer>

#include <vector>

class QGridLayout;
class QToolButton;

namespace app {

/// The examples of the open workshop as pictures; a click opens one in place of what is built.
class ExampleGallery : public QFrame
{
    Q_OBJECT

public:
    ExampleGallery(Session &session, const Theme &theme, QWidget *parent = nullptr);

    void popUp(const QWidget &anchor);
    const std::vector<QToolButton *> &cards() const { return m_cards; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fill();
    void paintNext();
    QToolButton *card(const lessons::Example &example);

    static constexpr QSize pictureSize{168, 124};

    Session &m_session;
    const Theme &m_theme;
    QGridLayout *m_grid;
    std::vector<QToolButton *> m_cards;
    std::size_t m_painted = 0;
    QTimer m_later;
};

}
