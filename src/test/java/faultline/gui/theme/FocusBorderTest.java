package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A list or table without a selection shows that it has the focus. */
class FocusBorderTest {

    private boolean focused;

    @BeforeEach
    void install() {
        runOnEdt(Theme.LIGHT::install);
    }

    @AfterAll
    static void installTheLightTheme() {
        runOnEdt(Theme.LIGHT::install);
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void aListWithoutASelectionShowsTheFocusInEachTheme(Theme theme) {
        runOnEdt(theme::install);
        JScrollPane pane = callOnEdt(() -> new JScrollPane(new JList<>(new String[] {"desk", "sofa"}) {
            @Override
            public boolean isFocusOwner() {
                return focused;
            }
        }));
        int accent = theme.colours().accent().getRGB();
        assertNotEquals(accent, leftEdge(pane));
        focused = true;
        assertEquals(accent, leftEdge(pane));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void anEmptyTableShowsTheFocus(boolean lined) {
        JScrollPane pane = callOnEdt(() -> {
            JScrollPane made = new JScrollPane(new JTable(0, 2) {
                @Override
                public boolean isFocusOwner() {
                    return focused;
                }
            });
            made.setBorder(new FocusRing.FocusBorder(lined));
            return made;
        });
        ThemeColours colours = Theme.LIGHT.colours();
        assertEquals((lined ? colours.line() : colours.field()).getRGB(), leftEdge(pane));
        focused = true;
        assertEquals(colours.accent().getRGB(), leftEdge(pane));
    }

    /** Returns the colour in the middle of the left edge. */
    private static int leftEdge(JScrollPane pane) {
        return callOnEdt(() -> {
            pane.setSize(120, 80);
            pane.doLayout();
            BufferedImage image = new BufferedImage(120, 80, BufferedImage.TYPE_INT_ARGB);
            Graphics2D graphics = image.createGraphics();
            pane.paint(graphics);
            graphics.dispose();
            return image.getRGB(0, 60);
        });
    }
}
