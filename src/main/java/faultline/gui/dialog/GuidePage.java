package faultline.gui.dialog;

import faultline.gui.action.Keystrokes;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import faultline.paint.surface.Palette;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import javax.swing.JComponent;
import javax.swing.JEditorPane;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.text.BadLocationException;
import javax.swing.text.Document;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.StyleSheet;

/** The text of the guide, loaded and styled. Loading takes as long as several frames and may be done on any thread. */
record GuidePage(HTMLEditorKit kit, Document document) {

    /** Pixels. */
    private static final int TRIAL_WIDTH = 600;

    /** Loads the guide in the current language, colours and text size. */
    static GuidePage load() {
        HTMLEditorKit kit = new HTMLEditorKit();
        kit.setStyleSheet(createStyleSheet(kit));
        Document document = kit.createDefaultDocument();
        String text = Keystrokes.withMenuModifier(Messages.loadPage("guide"));
        layOut(text);
        try {
            kit.read(new StringReader(text), document, 0);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        } catch (BadLocationException broken) {
            throw new IllegalStateException(broken);
        }
        return new GuidePage(kit, document);
    }

    /** Lays the text out once, so that classes and fonts are loaded when the event dispatch thread does so. */
    private static void layOut(String text) {
        BasicHTML.createHTMLView(new DetachedComponent(), text).setSize(TRIAL_WIDTH, TRIAL_WIDTH);
    }

    /** A component that is in no window, so that what it shows may be laid out on any thread. */
    private static final class DetachedComponent extends JComponent {
        @Override
        public void revalidate() {
            // There is nothing to lay out.
        }

        @Override
        public void repaint() {
            // There is nothing to paint.
        }
    }

    /** Returns a style sheet for this page only; the kit's own sheet is shared by all kits. */
    private static StyleSheet createStyleSheet(HTMLEditorKit kit) {
        StyleSheet styles = new StyleSheet();
        styles.addStyleSheet(kit.getStyleSheet());
        int size = TextSize.scaled(13);
        styles.addRule("body { font-family: SansSerif; font-size: " + size + "px; color: "
                + Palette.toHex(Theme.currentColours().text()) + "; margin: 12px 18px 12px 18px }");
        styles.addRule("h1 { font-size: " + TextSize.scaled(19) + "px; margin-bottom: 4px }");
        styles.addRule("h2 { font-size: " + TextSize.scaled(15) + "px; margin-top: 14px; margin-bottom: 2px; color: "
                + Palette.toHex(Theme.currentColours().accent()) + " }");
        styles.addRule("p, li { margin-top: 4px; margin-bottom: 4px }");
        return styles;
    }

    /** Creates the component that displays the page. Event dispatch thread only. */
    JEditorPane createPane() {
        JEditorPane pane = new JEditorPane();
        // Otherwise one CSS pixel would be 1.3 screen pixels.
        pane.putClientProperty(JEditorPane.W3C_LENGTH_UNITS, true);
        pane.setEditable(false);
        showIn(pane);
        // The editor kit brings its own accessible context.
        UiText.name(pane, "guide.title");
        return pane;
    }

    /** Displays the page in a component. Event dispatch thread only. */
    void showIn(JEditorPane pane) {
        pane.setEditorKit(kit);
        pane.setDocument(document);
        pane.setCaretPosition(0);
        pane.setBackground(Theme.currentColours().field());
    }
}
