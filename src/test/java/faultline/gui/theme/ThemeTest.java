package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JScrollBar;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.JToolTip;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ThemeTest {

    @Test
    void theListOfANarrowComboBoxIsAsWideAsItsTexts() {
        runOnEdt(() -> {
            JComboBox<String> box = new JComboBox<>(new String[] {"left", "the sensor at the rear on the right side"});
            FlatComboBoxUI.FlatPopup popup =
                    (FlatComboBoxUI.FlatPopup) box.getUI().getAccessibleChild(box, 0);
            int texts = popup.getList().getPreferredSize().width;
            assertTrue(popup.widthFor(44, 400) >= texts);
            assertTrue(popup.widthFor(44, 20) > popup.widthFor(44, 400), "room for a scroll bar");
            assertEquals(2 * texts, popup.widthFor(2 * texts, 400));
        });
    }

    @Test
    void namesThatLookLikeHtmlAreShownAsTheyAre() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            String name = "<html><b>name";
            JTable table = new JTable(new Object[][] {{name}}, new Object[] {name});
            JToolTip tip = new JToolTip();
            tip.setTipText(name);
            JComponent cell = (JComponent) table.prepareRenderer(table.getCellRenderer(0, 0), 0, 0);
            for (JComponent component :
                    List.of(new JLabel(name), new JCheckBox(name), new JMenuItem(name), tip, cell)) {
                assertNull(
                        component.getClientProperty(BasicHTML.propertyKey),
                        component.getClass().getSimpleName());
            }
        });
    }

    @ParameterizedTest
    @EnumSource(TextSize.class)
    void aLongToolTipHasSeveralLinesAndItsTextStaysAsItIs(TextSize size) {
        runOnEdt(() -> {
            size.install();
            Theme.LIGHT.install();
            JToolTip tip = new JToolTip();
            tip.setTipText("A tip");
            Dimension one = tip.getPreferredSize();
            String text = "The wall is visible from F3 to F4. ".repeat(10).strip();
            tip.setTipText(text);
            Dimension several = tip.getPreferredSize();
            assertTrue(several.width <= TextSize.scaled(640), several.toString());
            assertTrue(several.height > 3 * one.height, several.toString());
            assertEquals(text, tip.getAccessibleContext().getAccessibleDescription());
            tip.setSize(several);
            int[] ink = inkOfRows(tip);
            long lines = IntStream.range(1, ink.length)
                    .filter(y -> ink[y - 1] == 0 && ink[y] > 0)
                    .count();
            assertTrue(lines > 3 && lines < 9, "lines: " + lines);
        });
    }

    /** Returns how many pixels in each row of a tip differ from its background. */
    private static int[] inkOfRows(JToolTip tip) {
        BufferedImage image = new BufferedImage(tip.getWidth(), tip.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        tip.paint(graphics);
        graphics.dispose();
        int background = image.getRGB(0, 0);
        return IntStream.range(0, tip.getHeight())
                .map(y -> (int) IntStream.range(0, tip.getWidth())
                        .filter(x -> image.getRGB(x, y) != background)
                        .count())
                .toArray();
    }

    @AfterEach
    void light() {
        runOnEdt(TextSize.NORMAL::install);
        runOnEdt(Theme.LIGHT::install);
    }

    @Test
    void switchingTheThemeLeavesNoPixelOfTheOtherBackground() {
        JPanel panel = callOnEdt(() -> {
            Theme.LIGHT.install();
            return everyControl();
        });
        BufferedImage light = callOnEdt(() -> picture(panel));
        runOnEdt(() -> {
            Theme.DARK.install();
            SwingUtilities.updateComponentTreeUI(panel);
        });
        BufferedImage switched = callOnEdt(() -> picture(panel));
        BufferedImage fresh = callOnEdt(() -> picture(everyControl()));
        assertEquals(0, differing(switched, fresh), "a switched panel looks like a new one");
        assertTrue(differing(light, switched) > light.getWidth() * light.getHeight() / 2);
        Color ground = ThemeColours.LIGHT.background();
        assertEquals(0, count(switched, ground.getRGB()), "light ground on dark");
    }

    @Test
    void theThemeThatIsInstalledIsTheCurrentOne() {
        runOnEdt(Theme.DARK::install);
        assertEquals(Theme.DARK, callOnEdt(Theme::current));
    }

    @Test
    void textFieldsLeaveTheKeyOfTheGalleryToTheMenu() {
        runOnEdt(Theme.LIGHT::install);
        KeyStroke gallery = KeyStroke.getKeyStroke("control shift O");
        for (JTextComponent field : callOnEdt(() -> List.of(
                new JTextField(),
                new JTextArea(),
                ((JSpinner.DefaultEditor) new JSpinner().getEditor()).getTextField()))) {
            assertNull(
                    callOnEdt(() -> field.getInputMap().get(gallery)),
                    field.getClass().getName());
        }
    }

    private static JPanel everyControl() {
        JPanel panel = new JPanel();
        panel.setLayout(new BoxLayout(panel, BoxLayout.PAGE_AXIS));
        JToggleButton down = new JToggleButton("Down");
        down.setSelected(true);
        JCheckBox ticked = new JCheckBox("Ticked");
        ticked.setSelected(true);
        JButton primary = new JButton("Primary");
        primary.putClientProperty(ButtonPainter.PRIMARY, true);
        primary.updateUI();
        Component[] controls = {
            new JLabel("Label"),
            new JButton("Button"),
            primary,
            down,
            ticked,
            new JCheckBox("Empty"),
            new JTextField("Text"),
            new JSpinner(),
            new JComboBox<>(new String[] {"One"}),
            new JSlider(),
            new JScrollBar(JScrollBar.HORIZONTAL)
        };
        for (Component control : controls) {
            panel.add(control);
        }
        return panel;
    }

    private static BufferedImage picture(JPanel panel) {
        panel.setSize(240, 420);
        ComponentFinder.layOut(panel);
        BufferedImage image = new BufferedImage(240, 420, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        panel.paint(graphics);
        graphics.dispose();
        return image;
    }

    private static int differing(BufferedImage one, BufferedImage other) {
        int differing = 0;
        for (int x = 0; x < one.getWidth(); x++) {
            for (int y = 0; y < one.getHeight(); y++) {
                differing += one.getRGB(x, y) == other.getRGB(x, y) ? 0 : 1;
            }
        }
        return differing;
    }

    private static int count(BufferedImage image, int rgb) {
        int count = 0;
        for (int x = 0; x < image.getWidth(); x++) {
            for (int y = 0; y < image.getHeight(); y++) {
                count += image.getRGB(x, y) == rgb ? 1 : 0;
            }
        }
        return count;
    }
}
