// Renders a home with Sweet Home 3D's own photo renderer, so that its picture can be set beside ours.
//
// Usage (bench/peers/sweethome.sh gives the class path):
//   java -cp JARS sweethome.java HOME.sh3d OUT.png [WIDTHxHEIGHT] [HIGH|LOW] [CAMERA]
// HIGH is the best of the four qualities of its photo dialog, LOW the one before it. CAMERA is the number of a stored
// point of view, from 1; without it (or with 0) it is where the home's virtual visitor stands. The home's light, sky
// and hour are left as they are in the file. Without words: 640x480 HIGH 0.
// Prints one line of JSON: "seconds" is the render call alone, in which the renderer also loads the models and the
// textures; reading the home and writing the PNG are not counted.
import com.eteks.sweethome3d.io.DefaultUserPreferences;
import com.eteks.sweethome3d.io.HomeFileRecorder;
import com.eteks.sweethome3d.j3d.AbstractPhotoRenderer.Quality;
import com.eteks.sweethome3d.j3d.PhotoRenderer;
import com.eteks.sweethome3d.model.Camera;
import com.eteks.sweethome3d.model.Home;
import com.eteks.sweethome3d.model.ObserverCamera;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;

class sweethome {
    public static void main(String[] words) {
        int code = 0;
        try {
            if (words.length < 2 || words.length > 5) {
                throw new IllegalArgumentException("usage: HOME.sh3d OUT.png [WIDTHxHEIGHT] [HIGH|LOW] [CAMERA]");
            }
            run(words);
        } catch (IllegalArgumentException trouble) {
            System.err.println("sweethome: " + trouble.getMessage());
            code = 2;
        } catch (Throwable trouble) {
            trouble.printStackTrace();
            code = 1;
        }
        System.exit(code);  // the loaders and Java 3D leave threads behind that would keep the program alive
    }

    static void run(String[] words) throws Exception {
        String[] size = (words.length > 2 ? words[2] : "640x480").split("x");
        if (size.length != 2) {
            throw new IllegalArgumentException("the size has to be like 640x480");
        }
        int width = Integer.parseInt(size[0]);
        int height = Integer.parseInt(size[1]);
        Quality quality = Quality.valueOf(words.length > 3 ? words[3] : "HIGH");
        int number = words.length > 4 ? Integer.parseInt(words[4]) : 0;

        // The program itself opens homes with these words: the XML entry is read rather than the Java objects.
        Home home = new HomeFileRecorder(0, false, new DefaultUserPreferences(), false, true, true).readHome(words[0]);
        List<Camera> stored = home.getStoredCameras();
        if (number < 0 || number > stored.size()) {
            throw new IllegalArgumentException("the home has " + stored.size() + " stored cameras");
        }
        Camera wanted = number == 0 ? home.getObserverCamera() : stored.get(number - 1);
        Camera camera = goTo(home, wanted);

        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        PhotoRenderer renderer = new PhotoRenderer(home, quality);
        long start = System.nanoTime();
        renderer.render(image, camera, (picture, flags, x, y, w, h) -> true);
        double seconds = (System.nanoTime() - start) / 1e9;
        renderer.dispose();

        if (!ImageIO.write(image, "png", new File(words[1]))) {
            throw new IllegalStateException("could not write " + words[1]);
        }
        System.out.println(String.format(Locale.ROOT,
            "{\"home\": %s, \"camera\": %s, \"quality\": \"%s\", \"width\": %d, \"height\": %d, \"threads\": %d, "
                + "\"seconds\": %.2f}",
            quoted(new File(words[0]).getName()), quoted(wanted.getName()), quality, width, height,
            Runtime.getRuntime().availableProcessors(), seconds));
    }

    // Goes to a point of view as the program does: by moving the visitor, or the view from above, there. The renderer
    // asks which of the two the home looks through, and lights the home otherwise for each.
    static Camera goTo(Home home, Camera wanted) {
        Camera mover = wanted instanceof ObserverCamera ? home.getObserverCamera() : home.getTopCamera();
        if (mover != wanted) {
            mover.setCamera(wanted);
        }
        home.setCamera(mover);
        return mover;
    }

    static String quoted(String text) {
        return text == null ? "null" : '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
