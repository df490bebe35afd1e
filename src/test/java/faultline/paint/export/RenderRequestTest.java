package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.scene.Layer;
import faultline.paint.scene.Pixels;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.SampleReferenceOverlays;
import faultline.paint.scene.SceneLabels;
import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Palette;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.awt.print.PageFormat;
import java.awt.print.Paper;
import java.awt.print.Printable;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** Pictures of a view as pixels, as SVG and on paper. */
class RenderRequestTest {

    private static final Frame FRAME = SampleFrames.fullFrame();

    private static RenderRequest request(Frame frame) {
        return new RenderRequest(
                frame, FrameRenderer.fitCamera(frame.snapshot(), 600, 400), Palette.LIGHT, Layer.defaults());
    }

    @Test
    void twiceTheResolutionShowsTheSamePicture() {
        BufferedImage fine = request(FRAME).toImage(2);
        assertEquals(1200, fine.getWidth());
        assertEquals(800, fine.getHeight());
        BufferedImage halved = new BufferedImage(600, 400, BufferedImage.TYPE_INT_RGB);
        halved.createGraphics().drawImage(fine.getScaledInstance(600, 400, Image.SCALE_AREA_AVERAGING), 0, 0, null);
        int different = Pixels.countVisiblyDifferent(request(FRAME).toImage(1), halved);
        assertTrue(different < 600 * 400 / 50, different + " pixels differ");
    }

    @Test
    void theSvgContainsTheRobotItsPathAndTheTexts() throws Exception {
        Document svg = parse(request(FRAME).toSvg());
        assertEquals("600", svg.getDocumentElement().getAttribute("width"));
        assertEquals("0 0 600 400", svg.getDocumentElement().getAttribute("viewBox"));
        assertTrue(
                elements(svg, "path").anyMatch(path -> path.getAttribute("fill").equals("#877df7")),
                "the robot's body");
        assertTrue(
                elements(svg, "path")
                        .anyMatch(path -> path.getAttribute("stroke").equals("#4338ca")),
                "the robot's path");
        assertTrue(
                elements(svg, "path")
                        .anyMatch(path -> !path.getAttribute("stroke-dasharray").isEmpty()),
                "dashed lines");
        assertTrue(
                elements(svg, "text").anyMatch(text -> text.getTextContent().contains("12.48")),
                "the badge of the first collision");
    }

    @Test
    void aReferenceRunShowsItsPathOutlineFirstDifferenceAndCaption() throws Exception {
        RenderRequest without = request(FRAME);
        ReferenceOverlay overlay = SampleReferenceOverlays.office();
        Document svg = parse(new RenderRequest(
                        FRAME,
                        without.camera(),
                        Palette.LIGHT,
                        new ScenePainter(Layer.defaults(), SceneLabels.ENGLISH),
                        List.of(overlay))
                .toSvg());
        List<Element> strokes = elements(svg, "path")
                .filter(path -> path.getAttribute("stroke").equals("#9b2f8f"))
                .toList();
        assertTrue(
                strokes.stream()
                        .anyMatch(path -> path.getAttribute("stroke-width").equals("1")),
                "its path");
        assertTrue(
                strokes.stream()
                        .anyMatch(path -> !path.getAttribute("stroke-dasharray").isEmpty()),
                "its outline");
        assertTrue(
                elements(svg, "text").anyMatch(text -> text.getTextContent()
                        .equals(overlay.marks().get(0).label())),
                "the mark");
        assertTrue(
                elements(svg, "text").anyMatch(text -> text.getTextContent()
                        .equals(overlay.caption().get(0))),
                "the caption");
        assertTrue(elements(parse(without.toSvg()), "path")
                .noneMatch(path -> path.getAttribute("stroke").equals("#9b2f8f")));
    }

    @Test
    void theRobotsBodyLiesAtItsPositionInTheCamera() throws Exception {
        RenderRequest picture = request(SampleFrames.frameOf(new Pose(2, 1, 0)));
        Element body = elements(parse(picture.toSvg()), "path")
                .filter(path -> path.getAttribute("fill").equals("#877df7"))
                .findFirst()
                .orElseThrow();
        double[] numbers = Arrays.stream(body.getAttribute("d").split("[^0-9.-]+"))
                .filter(word -> !word.isEmpty())
                .mapToDouble(Double::parseDouble)
                .toArray();
        double left = IntStream.range(0, numbers.length / 2)
                .mapToDouble(i -> numbers[2 * i])
                .min()
                .orElseThrow();
        double right = IntStream.range(0, numbers.length / 2)
                .mapToDouble(i -> numbers[2 * i])
                .max()
                .orElseThrow();
        assertEquals(0.25 * picture.camera().scale(), right - left, 0.05, "the body is 0.25 m long");
        assertEquals(picture.camera().toScreen(new Vector2(2, 1)).x(), (left + right) / 2, 0.05);
    }

    @Test
    void thePictureIsCentredOnASinglePage() {
        Paper paper = new Paper();
        paper.setSize(700, 1000);
        paper.setImageableArea(50, 50, 600, 900);
        PageFormat format = new PageFormat();
        format.setPaper(paper);
        BufferedImage page = new BufferedImage(700, 1000, BufferedImage.TYPE_INT_RGB);
        PrintablePage printed = new PrintablePage(request(FRAME));
        assertEquals(Printable.PAGE_EXISTS, printed.print(page.createGraphics(), format, 0));
        assertEquals(Printable.NO_SUCH_PAGE, printed.print(page.createGraphics(), format, 1));
        assertEquals(0, Pixels.countVisiblyDifferent(request(FRAME).toImage(1), page.getSubimage(50, 300, 600, 400)));
        assertEquals(0, page.getRGB(350, 299) & 0xFFFFFF, "nothing is printed above the picture");
    }

    @Test
    void thePaperIsTurnedForAWidePicture() {
        RenderRequest tall = new RenderRequest(
                FRAME, FrameRenderer.fitCamera(FRAME.snapshot(), 400, 600), Palette.LIGHT, Layer.defaults());
        for (int before : new int[] {PageFormat.PORTRAIT, PageFormat.LANDSCAPE}) {
            PageFormat format = new PageFormat();
            format.setOrientation(before);
            assertEquals(
                    PageFormat.LANDSCAPE,
                    new PrintablePage(request(FRAME)).oriented(format).getOrientation());
            assertEquals(
                    PageFormat.PORTRAIT,
                    new PrintablePage(tall).oriented(format).getOrientation());
            assertEquals(before, format.getOrientation());
        }
    }

    private static Document parse(String svg) throws Exception {
        return DocumentBuilderFactory.newDefaultInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
    }

    private static Stream<Element> elements(Document svg, String name) {
        NodeList found = svg.getElementsByTagName(name);
        return IntStream.range(0, found.getLength()).mapToObj(i -> (Element) found.item(i));
    }
}
