// Structural similarity (Wang et al. 2004) of two pictures x and y by the sum u = x + y and difference v = x
// - y.
//
// Written so that equal pictures give exactly 1 (v is 0), and that no digits are lost where both are bright
// and similar: with S = mean u, D = mean v, U and V the variances of u and v in the window,
//   SSIM = ((S^2 - D^2)/2 + C1) / ((S^2 + D^2)/2 + C1) * ((U - V)/2 + C2) / ((U + V)/2 + C2)

#define SSIM_C1 0.0001  // (0.01 L)^2 with the range L = 1
#define SSIM_C2 0.0009  // (0.03 L)^2

// Taps of the window: Gaussian of standard deviation 1.5 pixels, 11 taps, sum 1.
float ssimTap(int distance) {
    int d = abs(distance);
    return d == 0   ? float(0.26601172486179436)
           : d == 1 ? float(0.2130055377112537)
           : d == 2 ? float(0.10936068950970002)
           : d == 3 ? float(0.03600077212843083)
           : d == 4 ? float(0.007598758135239185)
           : d == 5 ? float(0.00102838008447911)
                    : float(0.0);
}

// The result of one window: 1 - SSIM, and its gradient, which with respect to the x of a pixel in the window
// is tap * (plain + ofSum u + ofDifference v).
struct SsimWindow {
    vec4 dissimilarity;
    vec4 plain;
    vec4 ofSum;
    vec4 ofDifference;
};

// Takes weighted means over the window of u, v, u^2 and v^2.
SsimWindow ssimWindow(vec4 u, vec4 v, vec4 uu, vec4 vv) {
    vec4 c1 = vec4(SSIM_C1);
    vec4 c2 = vec4(SSIM_C2);
    vec4 s = u * u;
    vec4 d = v * v;
    vec4 varU = max(uu - s, vec4(0.0)) * float(0.5);
    vec4 varV = max(vv - d, vec4(0.0)) * float(0.5);
    vec4 inverse1 = vec4(1.0) / ((s + d) * float(0.5) + c1);
    vec4 inverse2 = vec4(1.0) / (varU + varV + c2);
    vec4 unlikeMean = d * inverse1;
    vec4 unlikeStructure = (varV + varV) * inverse2;
    vec4 luminances = vec4(1.0) - unlikeMean;
    SsimWindow window;
    window.dissimilarity = unlikeMean + luminances * unlikeStructure;
    // Derivatives with respect to the variances, then to the means.
    vec4 slope = luminances * inverse2;
    window.ofSum = -slope * unlikeStructure;
    window.ofDifference = slope * ((varU + c2) * inverse2) * float(2.0);
    vec4 structures = (vec4(1.0) - unlikeStructure) * inverse1;
    vec4 byU = -structures * u * unlikeMean;
    vec4 byV = structures * v * ((s + c1 + c1) * inverse1);
    // d(var) = d(mean of squares) - 2 mean d(mean), and the mean of squares has the derivative 2 u; the 2 and
    // the half of the variance cancel.
    window.plain = byU + byV - window.ofSum * u - window.ofDifference * v;
    return window;
}
