package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;

import faultline.gui.Components;
import faultline.gui.theme.Theme;
import java.awt.AWTException;
import java.awt.Rectangle;
import java.awt.Robot;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComboBox;

/**
 * Writes pictures of the window, light and dark, for the documentation. Arguments: a scenario, a folder, and how far the run is to have come in
 * seconds. Needs a display, and {@code mvn test-compile} before:
 * <pre>{@code
 * mvn -q dependency:build-classpath -Dmdep.outputFile=target/classpath.txt
 * xvfb-run -a -s "-screen 0 1600x1000x24" java -cp "target/classes:target/test-classes:$(cat target/classpath.txt)" \
 *     faultline.gui.window.Screenshots scenarios/office.xml docs/images 62
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
                write(driver, folder.resolve("window-" + theme.name().toLowerCase(Locale.ROOT) + ".png"));
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

    private static void write(WindowDriver driver, Path file) throws IOException, AWTException {
        driver.robot().moveTo(driver.canvas(), 400, 300);
        Rectangle bounds = onEdt(driver.window()::getBounds);
        ImageIO.write(new Robot().createScreenCapture(bounds), "png", file.toFile());
    }
}
