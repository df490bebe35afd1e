package faultline.paint.export;

import faultline.paint.surface.Palette;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes an animated GIF that repeats forever. After the first picture only the area that has changed is written.
 * Instances are confined to one thread.
 */
public final class AnimatedGifWriter implements AutoCloseable {

    private static final String METADATA_FORMAT = "javax_imageio_gif_image_1.0";
    private static final byte[] LOOP_FOREVER = {1, 0, 0};

    private final ImageWriter writer =
            ImageIO.getImageWritersByFormatName("gif").next();
    private final ImageOutputStream stream;
    private final Palette palette;
    private final int sensors;
    private ColourQuantizer quantizer;
    private BufferedImage previousFrame;

    /**
     * Creates a writer for a stream, which is not closed. The colours of the palette, for a robot with a number of
     * sensors, differ from those of the pictures by less than 8 of 256 in each channel.
     */
    public AnimatedGifWriter(OutputStream out, Palette palette, int sensors) throws IOException {
        this.palette = palette;
        this.sensors = sensors;
        stream = new MemoryCacheImageOutputStream(out);
        writer.setOutput(stream);
        writer.prepareWriteSequence(null);
    }

    /**
     * Returns how long a film at real time shows a tick, counted from the first that is shown. It shows the first tick
     * and the first of each interval of a given delay, for that time or, if ticks are longer, until the next one.
     * Delays are in hundredths of a second; 0 for a tick that is not shown.
     */
    public static int delayOf(long ticks, double dt, int delay) {
        long picture = pictureIndex(ticks, dt, delay);
        boolean shown = ticks == 0 || ticks > 0 && picture > pictureIndex(ticks - 1, dt, delay);
        return shown ? (int) Math.max(1, pictureIndex(ticks + 1, dt, delay) - picture) * delay : 0;
    }

    private static long pictureIndex(long ticks, double dt, int delay) {
        return (long) Math.floor(ticks * dt * 100 / delay + 1e-6);
    }

    /** Adds a picture of the same size as the first, which is shown for a delay, hundredths of a second, positive. */
    public void addFrame(BufferedImage picture, int delay) throws IOException {
        if (quantizer == null) {
            quantizer = ColourQuantizer.of(palette, sensors, picture);
        }
        BufferedImage few = quantizer.quantize(picture);
        Rectangle part = previousFrame == null
                ? new Rectangle(few.getWidth(), few.getHeight())
                : changedArea(previousFrame, few);
        IIOMetadata details = frameMetadata(few, part, delay);
        writer.writeToSequence(new IIOImage(copyArea(few, part), null, details), null);
        stream.flushBefore(stream.getStreamPosition());
        previousFrame = few;
    }

    /**
     * Returns the smallest rectangle that contains all differences between two pictures; one pixel if there are none,
     * because it must not be empty.
     */
    static Rectangle changedArea(BufferedImage before, BufferedImage after) {
        byte[] old = ((DataBufferByte) before.getRaster().getDataBuffer()).getData();
        byte[] now = ((DataBufferByte) after.getRaster().getDataBuffer()).getData();
        int width = after.getWidth();
        int left = width;
        int right = -1;
        int top = -1;
        int bottom = -1;
        for (int i = 0; i < now.length; i++) {
            if (old[i] != now[i]) {
                left = Math.min(left, i % width);
                right = Math.max(right, i % width);
                top = top < 0 ? i / width : top;
                bottom = i / width;
            }
        }
        return right < 0 ? new Rectangle(1, 1) : new Rectangle(left, top, right - left + 1, bottom - top + 1);
    }

    /** Returns a copy of an area: the writer would read the pixels of a view from the wrong position. */
    private static BufferedImage copyArea(BufferedImage picture, Rectangle part) {
        BufferedImage cut = new BufferedImage(
                part.width, part.height, picture.getType(), (IndexColorModel) picture.getColorModel());
        cut.setData(picture.getSubimage(part.x, part.y, part.width, part.height).getData());
        return cut;
    }

    private IIOMetadata frameMetadata(BufferedImage picture, Rectangle part, int delay) throws IIOInvalidTreeException {
        IIOMetadata details = writer.getDefaultImageMetadata(new ImageTypeSpecifier(picture), null);
        IIOMetadataNode root = new IIOMetadataNode(METADATA_FORMAT);
        root.appendChild(node(
                "ImageDescriptor",
                "imageLeftPosition=" + part.x + " imageTopPosition=" + part.y + " imageWidth=" + part.width
                        + " imageHeight=" + part.height + " interlaceFlag=FALSE"));
        root.appendChild(node(
                "GraphicControlExtension",
                "disposalMethod=doNotDispose userInputFlag=FALSE transparentColorFlag=FALSE"
                        + " transparentColorIndex=0 delayTime=" + delay));
        if (previousFrame == null) {
            root.appendChild(loopExtension());
        }
        details.mergeTree(METADATA_FORMAT, root);
        return details;
    }

    private static IIOMetadataNode loopExtension() {
        IIOMetadataNode extension = node("ApplicationExtension", "applicationID=NETSCAPE authenticationCode=2.0");
        extension.setUserObject(LOOP_FOREVER.clone());
        IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
        extensions.appendChild(extension);
        return extensions;
    }

    /** Returns a node; {@code attributes} are written as name=value, separated by spaces. */
    private static IIOMetadataNode node(String name, String attributes) {
        IIOMetadataNode node = new IIOMetadataNode(name);
        for (String attribute : attributes.split(" ")) {
            int equals = attribute.indexOf('=');
            node.setAttribute(attribute.substring(0, equals), attribute.substring(equals + 1));
        }
        return node;
    }

    /** Ends the file; the target stays open. */
    @Override
    public void close() throws IOException {
        try (stream) {
            if (previousFrame != null) {
                writer.endWriteSequence();
            }
        } finally {
            writer.dispose();
        }
    }
}
