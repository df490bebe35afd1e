package faultline.gui.window;

import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Window;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.StyleSheet;

/** The short guide, beside the window rather than in its way. */
final class GuideDialog extends JDialog {

    private static final Dimension SIZE = new Dimension(620, 560);

    GuideDialog(Window owner) {
        super(owner, Texts.text("guide.title"), ModalityType.MODELESS);
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        JScrollPane scroll = new JScrollPane(page());
        scroll.setPreferredSize(new Dimension(TextSize.scaled(SIZE.width), SIZE.height));
        content.add(scroll, BorderLayout.CENTER);
        content.add(buttons(), BorderLayout.SOUTH);
        setContentPane(content);
        pack();
        setLocationRelativeTo(owner);
    }

    private static JEditorPane page() {
        JEditorPane page = new JEditorPane();
        HTMLEditorKit kit = new HTMLEditorKit();
        kit.setStyleSheet(styles(kit));
        page.setEditorKit(kit);
        // Without this a pixel of the page would be 1.3 of the window.
        page.putClientProperty(JEditorPane.W3C_LENGTH_UNITS, true);
        page.setText(Texts.page("guide"));
        page.setEditable(false);
        page.setCaretPosition(0);
        page.setBackground(Theme.now().field());
        page.getAccessibleContext().setAccessibleName(Texts.text("guide.title"));
        return page;
    }

    /** The kit's own sheet is shared by all kits, so ours goes on top of it. */
    private static StyleSheet styles(HTMLEditorKit kit) {
        StyleSheet styles = new StyleSheet();
        styles.addStyleSheet(kit.getStyleSheet());
        int size = TextSize.scaled(13);
        styles.addRule("body { font-family: SansSerif; font-size: " + size + "px; color: " + hex(Theme.now().text()) + "; margin: 12px 18px 12px 18px }");
        styles.addRule("h1 { font-size: " + TextSize.scaled(19) + "px; margin-bottom: 4px }");
        styles.addRule("h2 { font-size: " + TextSize.scaled(15) + "px; margin-top: 14px; margin-bottom: 2px; color: " + hex(Theme.now().accent()) + " }");
        styles.addRule("p, li { margin-top: 4px; margin-bottom: 4px }");
        return styles;
    }

    private static String hex(Color colour) {
        return String.format(Locale.ROOT, "#%06x", colour.getRGB() & 0xFFFFFF);
    }

    private JPanel buttons() {
        JButton close = new JButton(Texts.text("dialog.close"));
        close.addActionListener(event -> dispose());
        getRootPane().setDefaultButton(close);
        getRootPane().registerKeyboardAction(event -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
        buttons.add(close);
        return buttons;
    }
}
