package faultline.floorplan;

import faultline.io.ByteCount;
import faultline.io.MessageText;
import faultline.scenario.xml.ProblemKind;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.Raster;
import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** Reads map images: PGM (P2 and P5) with its own code, and PNG, BMP, GIF or TIFF with the JDK. */
final class MapImageReader {

    private static final long MAX_BYTES = 512L << 20;
    private static final int BUFFER_BYTES = 1 << 16;
    private static final int MAX_SAMPLE_BITS = 16;
    /**
     * The names that the JDK's readers give their formats. It can also read JPEG, whose compression changes pixels, and
     * whose decoders may differ by a level of grey, so that the outlines would not be those of the map on each machine.
     */
    private static final Set<String> FORMATS = Set.of("png", "bmp", "gif", "tif");

    /** The names that the JDK gives the compressions of BMP files that are images of other formats. */
    private static final Set<String> EMBEDDED_FORMATS = Set.of("BI_JPEG", "BI_PNG");

    /** The sum of the red, green and blue of white in the colours of a palette. */
    private static final int WHITE_SUM = 3 * 255;

    private MapImageReader() {}

    /**
     * {@return the pixels of an image}
     *
     * @param file the image file
     * @throws FloorPlanException if the file is missing, is not an image, or is too large
     */
    static MapImage read(Path file) throws FloorPlanException {
        try {
            if (Files.notExists(file)) {
                throw new FloorPlanException(file, FloorPlanProblem.NO_SUCH_IMAGE.with());
            }
            if (!Files.isReadable(file)) {
                throw new FloorPlanException(file, ProblemKind.UNREADABLE_FILE.with());
            }
            if (!Files.isRegularFile(file)) {
                throw new FloorPlanException(file, FloorPlanProblem.IRREGULAR_IMAGE.with());
            }
            if (Files.size(file) > MAX_BYTES) {
                throw new FloorPlanException(
                        file,
                        ProblemKind.TOO_MANY_BYTES.with(
                                ByteCount.format(Files.size(file)), ByteCount.format(MAX_BYTES)));
            }
            byte[] start = readStart(file);
            if (start.length == 2 && start[0] == 'P' && start[1] >= '1' && start[1] <= '7') {
                try (InputStream in = new BufferedInputStream(Files.newInputStream(file), BUFFER_BYTES)) {
                    return new PgmReader(file, in).read();
                }
            }
            if (start.length == 2 && start[0] == (byte) 0x89 && start[1] == 'P') {
                return readPng(file);
            }
            return start.length == 2 && start[0] == 'G' && start[1] == 'I' ? readGif(file) : readOther(file);
        } catch (FloorPlanException e) {
            throw e;
        } catch (FileSystemException e) {
            // The message of this exception is only the name of the file.
            throw new FloorPlanException(file, ProblemKind.UNREADABLE_FILE.with());
        } catch (IOException | RuntimeException e) {
            throw new FloorPlanException(file, FloorPlanProblem.UNREADABLE_IMAGE.with(reason(e)));
        }
    }

    private static byte[] readStart(Path file) throws IOException {
        try (var in = Files.newInputStream(file)) {
            return in.readNBytes(2);
        }
    }

    /**
     * Returns the reason in words, as a message or as text. The runtime exceptions of the JDK's readers describe the
     * reader, not the file.
     */
    private static Object reason(Exception e) {
        if (e instanceof EOFException) {
            return FloorPlanProblem.ENDS_TOO_EARLY.with();
        }
        return e instanceof RuntimeException || e.getMessage() == null
                ? FloorPlanProblem.DAMAGED.with()
                : MessageText.oneLine(e.getMessage());
    }

    private static MapImage readGif(Path file) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file), BUFFER_BYTES);
                ImageInputStream image = GifExtensions.skip(in)) {
            return readWithImageIo(file, image);
        }
    }

    private static MapImage readPng(Path file) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file), BUFFER_BYTES)) {
            PngChecksums.check(file, in);
        }
        return readOther(file);
    }

    private static MapImage readOther(Path file) throws IOException {
        try (ImageInputStream in = new BufferedImageInput(Files.newByteChannel(file))) {
            return readWithImageIo(file, in);
        }
    }

    private static MapImage readWithImageIo(Path file, ImageInputStream in) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
        if (!readers.hasNext()) {
            throw new FloorPlanException(file, FloorPlanProblem.IMAGE_FORMAT.with());
        }
        ImageReader reader = readers.next();
        try {
            if (!FORMATS.contains(reader.getFormatName())) {
                throw new FloorPlanException(file, FloorPlanProblem.IMAGE_FORMAT.with());
            }
            reader.setInput(in, true, true);
            // A size that is stored in 32 bits without a sign is negative here.
            requireSize(file, Integer.toUnsignedLong(reader.getWidth(0)), Integer.toUnsignedLong(reader.getHeight(0)));
            if (reader.getFormatName().equals("bmp")) {
                requirePlainBmp(file, new StandardMetadata(reader.getImageMetadata(0)));
            }
            MapImage map = toMapImage(file, reader);
            return reader.getFormatName().equals("gif") ? onScreen(file, map, reader) : map;
        } finally {
            reader.dispose();
        }
    }

    /** Refuses a BMP file that contains an image of another format, such as JPEG. */
    private static void requirePlainBmp(Path file, StandardMetadata metadata) throws FloorPlanException {
        String compression = metadata.value("CompressionTypeName");
        if (EMBEDDED_FORMATS.contains(compression)) {
            throw new FloorPlanException(file, FloorPlanProblem.COMPRESSION.with(compression));
        }
    }

    /** Returns the screen of a GIF file, of which its image may cover a part. */
    private static MapImage onScreen(Path file, MapImage image, ImageReader reader) throws IOException {
        StandardMetadata screen = new StandardMetadata(reader.getStreamMetadata());
        StandardMetadata place = new StandardMetadata(reader.getImageMetadata(0));
        int left = place.number("HorizontalPixelOffset");
        int top = place.number("VerticalPixelOffset");
        // Viewers extend a screen that does not contain the image.
        int width = Math.max(screen.number("HorizontalScreenSize"), left + image.width());
        int height = Math.max(screen.number("VerticalScreenSize"), top + image.height());
        requireSize(file, width, height);
        return image.on(width, height, left, top);
    }

    static void requireSize(Path file, long width, long height) throws FloorPlanException {
        if (!isPossible(width, height)) {
            throw new FloorPlanException(file, FloorPlanProblem.IMAGE_SIZE.with(width, height, MapImage.MAX_PIXELS));
        }
    }

    /** Returns whether an image may have a size, pixels. */
    static boolean isPossible(long width, long height) {
        return width >= 1 && height >= 1 && width <= MapImage.MAX_PIXELS && width * height <= MapImage.MAX_PIXELS;
    }

    private static MapImage toMapImage(Path file, ImageReader reader) throws IOException {
        boolean isTiff = reader.getFormatName().equals("tif");
        // The tags are checked first: the JDK reads some pixels wrongly, and calls some files damaged.
        PixelLayout layout = isTiff ? new TiffTags(file, reader.getImageMetadata(0)).layout() : null;
        BufferedImage image = reader.read(0);
        ColorModel colors = image.getColorModel();
        if (layout == null) {
            layout = new PixelLayout(
                    colors.getNumColorComponents(), colors.hasAlpha() ? colors.getNumColorComponents() : -1);
        }
        return colors instanceof ComponentColorModel && colors.getComponentSize(0) <= MAX_SAMPLE_BITS
                ? readSamples(image, layout, reader)
                : readColors(image, layout);
    }

    /** Returns an image from the colours of its palette, or from samples that are packed or floating-point numbers. */
    private static MapImage readColors(BufferedImage image, PixelLayout layout) {
        // getRGB rounds 16 bits of opacity to 8.
        Raster alpha = image.getAlphaRaster();
        MapImage map = new MapImage(image.getWidth(), image.getHeight(), WHITE_SUM);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                int argb = image.getRGB(x, y);
                int sum = (argb >> 16 & 0xff) + (argb >> 8 & 0xff) + (argb & 0xff);
                boolean isTransparent = argb >>> 24 < 255 || alpha != null && !isOpaque(alpha, x, y);
                map.set(y * map.width() + x, sum, layout.hasOpacity() && isTransparent);
            }
        }
        return map;
    }

    /**
     * Returns an image from its samples as the file stores them: getRGB would round samples of 16 bits to 8, and
     * convert them from a linear colour space or a colour profile.
     */
    private static MapImage readSamples(BufferedImage image, PixelLayout layout, ImageReader reader)
            throws IOException {
        Raster raster = image.getRaster();
        int max = (1 << image.getColorModel().getComponentSize(0)) - 1;
        int transparent = -1;
        int opaque = max;
        if (layout.hasOpacity() && layout.colors() == 1) {
            StandardMetadata metadata = new StandardMetadata(reader.getImageMetadata(0));
            // The JDK compares the transparent level of a PNG image of few bits with pixels that are already scaled.
            transparent = metadata.transparentSample(max).orElse(-1);
            // The JDK inverts all samples of a TIFF image that stores white as 0, also those of the opacity.
            opaque = metadata.isWhiteZero() ? 0 : max;
        }
        MapImage map = new MapImage(raster.getWidth(), raster.getHeight(), layout.colors() * max);
        for (int y = 0; y < raster.getHeight(); y++) {
            for (int x = 0; x < raster.getWidth(); x++) {
                int sum = raster.getSample(x, y, 0);
                for (int band = 1; band < layout.colors(); band++) {
                    sum += raster.getSample(x, y, band);
                }
                boolean isTransparent = layout.hasOpacity() && raster.getSample(x, y, layout.opacity()) != opaque;
                map.set(y * map.width() + x, sum, isTransparent || sum == transparent);
            }
        }
        return map;
    }

    private static boolean isOpaque(Raster alpha, int x, int y) {
        int bits = alpha.getSampleModel().getSampleSize(0);
        return bits > MAX_SAMPLE_BITS || alpha.getSample(x, y, 0) == (1 << bits) - 1;
    }
}
