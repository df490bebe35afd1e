package faultline.gui.window;

import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.Font;
import java.awt.KeyboardFocusManager;
import java.awt.event.MouseAdapter;
import java.util.function.LongConsumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;

/**
 * Shows over the canvas how a run ended, so that no other component moves when it appears. Where the button that goes
 * back would leave less room for the texts than it takes itself, it is below them.
 */
final class VerdictBanner extends JPanel {

    private static final int GAP = 8;
    private static final int MIN_WIDTH = 200;
    private static final GlyphIcon SUCCESS = new GlyphIcon(Glyph.CHECK, 18, colours -> colours.accent());
    private static final GlyphIcon FAILURE = new GlyphIcon(Glyph.WARNING, 18, colours -> colours.warning());

    private final JLabel icon = new JLabel();
    private final JTextArea title = UiText.wrappedText();
    private final JTextArea detail = UiText.wrappedText();
    private final JPanel buttons = new JPanel();
    private final JPanel below = new JPanel(new FlowLayout(FlowLayout.LEADING, 0, 0));
    private final JButton back = UiText.button("verdict.back");
    /** Null while there is none. */
    private transient RunVerdict verdict;

    private double dt;
    /** The language of the verdict. */
    private transient Language language = Messages.language();

    /** The width and the font for which the texts have been wrapped. */
    private int wrappedWidth;

    private transient Font wrappedFont;

    /** Creates a banner that is not visible; {@code seek} receives the tick to go back to. */
    VerdictBanner(LongConsumer seek) {
        super(new BorderLayout(GAP, 0));
        JButton close = new JButton(new GlyphIcon(Glyph.REMOVE, 14, null));
        UiText.nameAndTip(close, "verdict.close");
        close.setBorder(BorderFactory.createEmptyBorder(3, 5, 3, 5));
        close.addActionListener(event -> close());
        UiText.tip(back, "verdict.back.tip");
        back.addActionListener(event -> seek.accept(verdict.tickBefore(dt)));
        buttons.setOpaque(false);
        buttons.setLayout(new BoxLayout(buttons, BoxLayout.LINE_AXIS));
        buttons.add(back);
        buttons.add(Box.createHorizontalStrut(GAP));
        buttons.add(close);
        configureTexts();
        JPanel texts = new JPanel(new BorderLayout());
        texts.setOpaque(false);
        texts.add(title, BorderLayout.NORTH);
        texts.add(detail, BorderLayout.CENTER);
        below.setOpaque(false);
        below.setBorder(BorderFactory.createEmptyBorder(GAP, 0, 0, 0));
        texts.add(below, BorderLayout.SOUTH);
        icon.setVerticalAlignment(SwingConstants.TOP);
        add(icon, BorderLayout.LINE_START);
        add(texts, BorderLayout.CENTER);
        add(buttons, BorderLayout.LINE_END);
        // Clicks must not reach the canvas below.
        addMouseListener(new MouseAdapter() {});
        setVisible(false);
    }

    private void configureTexts() {
        RefreshSteps.add(title, RefreshSteps::embolden);
        title.setBorder(BorderFactory.createEmptyBorder());
        detail.setBorder(BorderFactory.createEmptyBorder(2, 0, 0, 0));
    }

    /** Shows a verdict; one that the user has closed stays closed until there is another. */
    void setVerdict(RunVerdict next, double newDt) {
        assert EventQueue.isDispatchThread();
        dt = newDt;
        if (next.equals(verdict)) {
            return;
        }
        boolean translated = verdict != null && next.event() == verdict.event() && language != Messages.language();
        language = Messages.language();
        boolean closed = translated && !isVisible();
        verdict = next;
        title.setText(next.title());
        icon.setIcon(next.success() ? SUCCESS : FAILURE);
        detail.setText(next.detail());
        detail.setVisible(!next.detail().isEmpty());
        // There is nothing before the start of the run.
        back.setVisible(next.event() > 0);
        wrapTexts();
        getAccessibleContext().setAccessibleName(next.title() + ". " + next.detail());
        updateBorder();
        setVisible(!closed);
    }

    /** Shows no verdict. */
    void clearVerdict() {
        assert EventQueue.isDispatchThread();
        verdict = null;
        close();
    }

    /** Hides the banner; the focus of one of its buttons moves to the canvas. */
    private void close() {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        boolean focused = owner != null && SwingUtilities.isDescendingFrom(owner, this);
        setVisible(false);
        if (focused) {
            getParent().requestFocusInWindow();
        }
    }

    @Override
    public Dimension getPreferredSize() {
        if (verdict != null && (roomWidth() != wrappedWidth || !title.getFont().equals(wrappedFont))) {
            wrapTexts();
        }
        return super.getPreferredSize();
    }

    /**
     * Chooses the place of the button, and gives the texts the width that they will have: their height depends on it.
     */
    private void wrapTexts() {
        wrappedWidth = roomWidth();
        wrappedFont = title.getFont();
        int backWidth = back.isVisible() ? back.getPreferredSize().width : 0;
        int rowWidth = buttons.getPreferredSize().width + (back.getParent() == below ? backWidth : 0);
        boolean narrow = widthBeside(rowWidth) < backWidth;
        JPanel place = narrow ? below : buttons;
        if (back.getParent() != place) {
            place.add(back, 0);
        }
        below.setVisible(narrow);
        int width = Math.max(MIN_WIDTH, widthBeside(narrow ? rowWidth - backWidth : rowWidth));
        title.setSize(width, Short.MAX_VALUE);
        detail.setSize(width, Short.MAX_VALUE);
    }

    private int widthBeside(int buttonsWidth) {
        return roomWidth() - icon.getPreferredSize().width - buttonsWidth - 5 * GAP;
    }

    private int roomWidth() {
        return getParent() == null ? 0 : getParent().getWidth();
    }

    private void updateBorder() {
        Color edge = verdict.success()
                ? Theme.currentColours().accent()
                : Theme.currentColours().warning();
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createLineBorder(edge, 2), BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP)));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBackground(Theme.currentColours().field());
        if (verdict != null) {
            updateBorder();
        }
    }
}
