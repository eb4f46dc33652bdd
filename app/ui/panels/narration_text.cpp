#include "app/ui/panels/narration_text.h"

#include "app/ui/panels/prose.h"

#include <QDesktopServices>

#include <cmath>

namespace app {

NarrationText::NarrationText(const Theme &theme, QWidget *parent) : QTextBrowser(parent), m_theme(theme)
{
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(this, &QTextBrowser::anchorClicked, this, [](const QUrl &url) {
        if (url.scheme() == "https")
            QDesktopServices::openUrl(url);
    });
    connect(&theme, &Theme::changed, this, &NarrationText::dress);
}

void NarrationText::setText(const QString &markdown)
{
    m_text = markdown;
    setAccessibleName(plainText(markdown));
    dress();
}

void NarrationText::setLarge(bool large)
{
    if (large == m_large)
        return;
    m_large = large;
    dress();
}

void NarrationText::dress()
{
    const Tokens &tokens = m_theme.tokens();
    // Between 13 px and 14 px, as near as whole sizes come to that.
    const ProseStyle small{14, 20, 6, tokens.ink2, tokens.ink, QFont::DemiBold, -0.15};
    const ProseStyle large{14, 22, 6, tokens.ink2, tokens.ink};
    setProse(*document(), m_text, m_large ? large : small, m_theme);
    const bool links = document()->toHtml().contains("<a ");
    // Tab stops here only if there is a link to reach.
    setFocusPolicy(links ? Qt::StrongFocus : Qt::ClickFocus);
    updateGeometry();
}

int NarrationText::heightForWidth(int width) const
{
    QTextDocument *text = document();
    const qreal was = text->textWidth();
    text->setTextWidth(width);
    const int height = static_cast<int>(std::ceil(text->size().height()));
    text->setTextWidth(was);
    return height;
}

QSize NarrationText::sizeHint() const
{
    return {240, heightForWidth(std::max(width(), 160))};
}

}
