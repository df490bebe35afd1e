package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import java.awt.BorderLayout;
import javax.swing.Box;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;

/** Tabs and the keys of what they contain, and names in menus. */
class UiTextTest {

    private final JList<String> list = new JList<>();
    private final JScrollPane scroll = new JScrollPane(list);

    private static int keysWithFocus(JComponent component) {
        int keys = 0;
        for (InputMap map = component.getInputMap(JComponent.WHEN_FOCUSED); map != null; map = map.getParent()) {
            keys += map.size();
        }
        return keys;
    }

    private void addTab() {
        JPanel content = new JPanel();
        content.add(scroll);
        UiText.addTab(new JTabbedPane(), "panel.run", content);
    }

    @Test
    void scrollPanesInATabHaveNoKeysOfTheirOwnSoTheTabKeyPassesThemBy() {
        addTab();
        assertEquals(0, keysWithFocus(scroll));
    }

    @Test
    void listsAndScrollPanesInATabLeaveTheKeysOfTheTabsToThem() {
        addTab();
        KeyStroke next = KeyStroke.getKeyStroke("ctrl PAGE_DOWN");
        assertEquals("none", list.getInputMap(JComponent.WHEN_FOCUSED).get(next));
        assertEquals(
                "none",
                scroll.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                        .get(next));
    }

    /** A dialog that does not fit the screen stays at its top while a text at its end changes. */
    @Test
    void aNewTextDoesNotScrollWhatContainsIt() {
        JTextArea text = callOnEdt(UiText::wrappedText);
        JScrollPane form = callOnEdt(() -> {
            JPanel fields = new JPanel(new BorderLayout());
            fields.add(Box.createVerticalStrut(500), BorderLayout.CENTER);
            fields.add(text, BorderLayout.SOUTH);
            JScrollPane pane = new JScrollPane(fields);
            pane.setSize(200, 100);
            ComponentFinder.layOut(pane);
            text.updateUI();
            text.setText("A plan is read. It has one outline.");
            return pane;
        });
        // The caret scrolls in a later event.
        runOnEdt(() -> {});
        runOnEdt(() -> assertEquals(0, form.getViewport().getViewPosition().y));
    }

    @Test
    void aLongNameIsShortenedInAMenu() {
        runOnEdt(() -> {
            JMenuItem item = UiText.menuText(new JMenuItem(), "robotMenu.repair", "sensor-".repeat(15));
            assertTrue(item.getText().matches("Repair (sensor-)+\\S*\\.\\.\\."), item.getText());
            assertTrue(
                    item.getPreferredSize().width < 500, item.getPreferredSize().toString());
            assertEquals("front-right", UiText.shortName("front-right"));
        });
    }
}
