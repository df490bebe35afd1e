package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;

import faultline.gui.Components;
import faultline.gui.theme.Theme;
import java.awt.AWTException;
import java.awt.Component;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.MultiResolutionImage;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JTabbedPane;

/**
 * Writes pictures of the window and its instruments, light and dark, for the documentation. Arguments: a scenario, a folder, and how far the run is to have come in
 * seconds. Needs a display, and {@code mvn test-compile} before:
 * <pre>{@code
 * mvn -q dependency:build-classpath -Dmdep.outputFile=target/classpath.txt
 * xvfb-run -a -s "-screen 0 1600x1000x24" java -cp "target/classes:target/test-classes:$(cat target/classpath.txt)" \
 *     faultline.gui.window.Screenshots scenarios/office.xml docs/images 140
 * }</pre>
 */
public final class Screenshots {

    private Screenshots() {
    }

    public static void main(String[] arguments) throws IOException, AWTException {
        Path folder = Files.createDirectories(Path.of(arguments[1]));
        for (Theme theme : Theme.values()) {
            try (WindowDriver driver = WindowDriver.open(theme, Path.of(arguments[0]))) {
                prepare(driver, Double.parseDouble(arguments[2]));
                String suffix = "-" + theme.name().toLowerCase(Locale.ROOT) + ".png";
                write(driver, driver.window(), folder.resolve("window" + suffix));
                JTabbedPane instruments = Components.named(driver.window(), JTabbedPane.class, "Instruments");
                show(driver, instruments, 1);
                write(driver, instruments, folder.resolve("timing" + suffix));
                show(driver, instruments, 2);
                write(driver, instruments, folder.resolve("events" + suffix));
            }
        }
        System.exit(0);
    }

    private static void prepare(WindowDriver driver, double seconds) {
        edt(() -> {
            Components.named(driver.window(), JComboBox.class, "Sensor").setSelectedItem("rear-right");
            Components.named(driver.window(), JButton.class, "Inject").doClick(0);
        });
        driver.choose("sensor5");
        for (int i = 0; i < 12; i++) {
            driver.choose("faster");
        }
        driver.choose("run");
        driver.waitForFrame("the run has come far enough", frame -> frame.world().time() > seconds);
        driver.choose("realTime");
        double settled = driver.frame().world().time() + 1.5;
        driver.waitForFrame("the pace has settled", frame -> frame.world().time() > settled);
    }

    private static void show(WindowDriver driver, JTabbedPane instruments, int tab) {
        edt(() -> instruments.setSelectedIndex(tab));
        double shown = driver.frame().world().time() + 0.5;
        driver.waitForFrame("the instrument shows", frame -> frame.world().time() > shown);
    }

    /** What is on the screen where a component is. */
    private static void write(WindowDriver driver, Component component, Path file) throws IOException, AWTException {
        driver.robot().moveTo(driver.canvas(), 400, 300);
        Rectangle bounds = onEdt(() -> new Rectangle(component.getLocationOnScreen(), component.getSize()));
        ImageIO.write((RenderedImage) sharpest(new Robot().createMultiResolutionScreenCapture(bounds)), "png", file.toFile());
    }

    /** Of a screen with several pixels to a unit, all of them. */
    private static Image sharpest(MultiResolutionImage image) {
        List<Image> variants = image.getResolutionVariants();
        return variants.get(variants.size() - 1);
    }
}
