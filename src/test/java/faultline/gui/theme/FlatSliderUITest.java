package faultline.gui.theme;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JSlider;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The thumb of a slider shows the focus. */
class FlatSliderUITest {

    private static final int WIDTH = 100;
    private static final int HEIGHT = 22;

    private boolean focused;

    @AfterAll
    static void installTheLightTheme() {
        runOnEdt(Theme.LIGHT::install);
    }

    /** The ring has a diameter of 8 pixels; antialiasing leaves the full colour in a part of its 25 pixels. */
    @ParameterizedTest
    @EnumSource(Theme.class)
    void aRingOnTheThumbShowsTheFocus(Theme theme) {
        runOnEdt(theme::install);
        JSlider slider = callOnEdt(() -> new JSlider(0, 100, 50) {
            @Override
            public boolean hasFocus() {
                return focused;
            }
        });
        Color ring = theme.colours().onAccent();
        assertEquals(0, countOnTrack(slider, ring));
        focused = true;
        assertTrue(countOnTrack(slider, ring) >= 8, "pixels in the colour of the ring");
    }

    /** A dialog that opens during a drag gets the release of the button. */
    @Test
    void aDragEndsWhenAnotherWindowGetsTheFocus() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            JSlider slider = new JSlider(0, 100, 50);
            slider.setSize(WIDTH, HEIGHT);
            drag(slider, MouseEvent.MOUSE_PRESSED, 20);
            assertTrue(slider.getValueIsAdjusting());
            int value = slider.getValue();
            loseFocus(slider, new FocusEvent(slider, FocusEvent.FOCUS_LOST, true));
            assertTrue(slider.getValueIsAdjusting(), "another program has the focus, and the button is still down");
            loseFocus(slider, new FocusEvent(slider, FocusEvent.FOCUS_LOST, true, new JLabel()));
            assertFalse(slider.getValueIsAdjusting());
            drag(slider, MouseEvent.MOUSE_DRAGGED, 70);
            assertFalse(slider.getValueIsAdjusting(), "the movement of the mouse that follows");
            assertEquals(value, slider.getValue());
        });
    }

    @ParameterizedTest
    @ValueSource(ints = {20, 50})
    void aDragMovesTheThumbFromWhereTheButtonWasPressed(int pressed) {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            JSlider slider = new JSlider(0, 100, 50);
            slider.setSize(WIDTH, HEIGHT);
            slider.dispatchEvent(new ComponentEvent(slider, ComponentEvent.COMPONENT_RESIZED));
            drag(slider, MouseEvent.MOUSE_PRESSED, pressed);
            int value = slider.getValue();
            drag(slider, MouseEvent.MOUSE_DRAGGED, pressed + 17);
            assertTrue(slider.getValueIsAdjusting());
            drag(slider, MouseEvent.MOUSE_DRAGGED, pressed + 34);
            assertEquals(value + 40, slider.getValue(), "34 of the 85 pixels of the track");
            drag(slider, MouseEvent.MOUSE_RELEASED, pressed + 34);
            assertFalse(slider.getValueIsAdjusting());
        });
    }

    private static void drag(JSlider slider, int event, int x) {
        slider.dispatchEvent(new MouseEvent(slider, event, 0, InputEvent.BUTTON1_DOWN_MASK, x, 9, 1, false, 1));
    }

    private static void loseFocus(JSlider slider, FocusEvent event) {
        List.of(slider.getFocusListeners()).forEach(listener -> listener.focusLost(event));
    }

    /** Returns the number of pixels of the thumb, in the middle of the slider, that nearly have a colour. */
    private static long countOnTrack(JSlider slider, Color colour) {
        return callOnEdt(() -> {
            slider.setSize(WIDTH, HEIGHT);
            slider.doLayout();
            BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = image.createGraphics();
            slider.paint(graphics);
            graphics.dispose();
            return IntStream.range(0, 9 * 9)
                    .mapToObj(i -> new Color(image.getRGB(WIDTH / 2 - 4 + i % 9, HEIGHT / 2 - 4 + i / 9)))
                    .filter(pixel -> Math.abs(pixel.getRed() - colour.getRed())
                                    + Math.abs(pixel.getGreen() - colour.getGreen())
                                    + Math.abs(pixel.getBlue() - colour.getBlue())
                            < 90)
                    .count();
        });
    }
}
