package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.paint.scene.Pixels;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class ReadmePicturesTest {

    /** The share of pixels that may differ, because letters depend on the machine's fonts. */
    private static final double LETTERS = 0.03;

    /** If it does not, {@code src/conf/screenshots docs} makes the pictures again. */
    @Test
    void thePictureOfTwoFaultsShowsWhatTheProgramDoesToday() throws Exception {
        BufferedImage shown = ImageIO.read(Path.of("docs/images/two-faults.png").toFile());
        BufferedImage now = ReadmePictures.twoFaults().toImage(1);
        double share = Pixels.countVisiblyDifferent(shown, now) / (double) (now.getWidth() * now.getHeight());
        assertTrue(share < LETTERS, share + " of the pixels differ");
    }
}
