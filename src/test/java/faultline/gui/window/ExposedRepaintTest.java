package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.ColorModel;
import javax.swing.JComponent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A window is painted again when it is activated, on scaled screens only. */
class ExposedRepaintTest {

    /** The configuration of a screen with a scale. */
    private static final class Scaled extends GraphicsConfiguration {
        private final double scale;

        Scaled(double scale) {
            this.scale = scale;
        }

        @Override
        public GraphicsDevice getDevice() {
            throw new UnsupportedOperationException();
        }

        @Override
        public ColorModel getColorModel() {
            return ColorModel.getRGBdefault();
        }

        @Override
        public ColorModel getColorModel(int transparency) {
            return ColorModel.getRGBdefault();
        }

        @Override
        public AffineTransform getDefaultTransform() {
            return AffineTransform.getScaleInstance(scale, scale);
        }

        @Override
        public AffineTransform getNormalizingTransform() {
            return new AffineTransform();
        }

        @Override
        public Rectangle getBounds() {
            return new Rectangle(1600, 1000);
        }
    }

    /** A component that counts its repaint requests. */
    @SuppressWarnings("serial")
    private static final class Contents extends JComponent {
        private final transient GraphicsConfiguration screen;
        private int repaints;

        Contents(double scale) {
            screen = new Scaled(scale);
        }

        @Override
        public GraphicsConfiguration getGraphicsConfiguration() {
            return screen;
        }

        @Override
        public void repaint() {
            repaints++;
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "1.25, 1", "1.5, 1", "2, 1"})
    void anActivatedWindowIsPaintedOnScaledScreens(double scale, int repaints) {
        Contents contents = new Contents(scale);
        contents.repaints = 0;
        new ExposedRepaint(contents).windowActivated(null);
        assertEquals(repaints, contents.repaints);
    }
}
